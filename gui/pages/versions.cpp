#include "gui/pages/versions.h"

#include <vtkVersion.h>

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QSysInfo>
#include <QThread>

#include "gui/built_with.h"

namespace vallecula::gui {
namespace {

QString sqlite_version() {
  constexpr const char* kName = "version of SQLite";
  QString version;
  {
    QSqlDatabase memory = QSqlDatabase::addDatabase("QSQLITE", kName);
    memory.setDatabaseName(":memory:");
    if (memory.open()) {
      QSqlQuery query("select sqlite_version()", memory);
      if (query.next()) version = query.value(0).toString();
    }
  }
  QSqlDatabase::removeDatabase(kName);
  return version;
}

}  // namespace

std::vector<Part> program_parts() {
  return {{"Vallecula", VALLECULA_VERSION, "AGPL-3.0"},
          {"Qt", qVersion(), "LGPL-3.0"},
          {"VTK", vtkVersion::GetVTKVersion(), "BSD-3-Clause"},
          {"TetGen", VALLECULA_WITH_TETGEN, "AGPL-3.0"},
          {"GDCM", VALLECULA_WITH_GDCM, "BSD-3-Clause"},
          {"OpenCV", VALLECULA_WITH_OPENCV, "Apache-2.0"},
          {"SQLite", sqlite_version(), "public domain"},
          {"Eigen", VALLECULA_WITH_EIGEN, "MPL-2.0"},
          {"yaml-cpp", VALLECULA_WITH_YAML_CPP, "MIT"},
          {"libsodium", VALLECULA_WITH_SODIUM, "ISC"},
          {"hidapi", VALLECULA_WITH_HIDAPI, "BSD-3-Clause"},
          {"libusb", VALLECULA_WITH_LIBUSB, "LGPL-2.1"},
          {"spdlog", VALLECULA_WITH_SPDLOG, "MIT"},
          {"CLI11", VALLECULA_WITH_CLI11, "BSD-3-Clause"}};
}

QString opengl_renderer() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return {};
  const auto text = [&context](GLenum what) {
    return QString::fromLatin1(reinterpret_cast<const char*>(context.functions()->glGetString(what)));
  };
  const QString told = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  context.doneCurrent();
  return told;
}

std::vector<std::string> system_lines() {
  QStringList parts;
  for (const Part& part : program_parts()) parts << part.name + " " + part.version;
  std::vector<std::string> lines{parts.join(", ").toStdString()};
  lines.push_back((QSysInfo::prettyProductName() + ", " + QSysInfo::kernelType() + " " + QSysInfo::kernelVersion() + ", " +
                   QSysInfo::currentCpuArchitecture() + ", " + QString::number(QThread::idealThreadCount()) + " processors")
                      .toStdString());
  for (const QScreen* screen : QGuiApplication::screens())
    lines.push_back(QString("screen %1 x %2, scale %3, %4 Hz")
                        .arg(screen->size().width())
                        .arg(screen->size().height())
                        .arg(screen->devicePixelRatio())
                        .arg(screen->refreshRate(), 0, 'f', 0)
                        .toStdString());
  const QString renderer = opengl_renderer();
  lines.push_back("drawn by " + (renderer.isEmpty() ? std::string("no OpenGL") : renderer.toStdString()));
  return lines;
}

}  // namespace vallecula::gui
