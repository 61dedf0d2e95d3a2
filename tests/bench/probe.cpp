#include <QApplication>
#include <QElapsedTimer>
#include <QVBoxLayout>
#include <QLabel>
#include <cstdio>
#include <time.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>
#include "gui/pages/window_application.h"
#include "gui/session/user_paths.h"
#include "gui/session/trial_session.h"
#include "gui/session/virtual_display.h"
#include "gui/views/operator_view.h"
#include "pipeline/package/patient_package.h"
using namespace vallecula; using namespace vallecula::gui;
static double cpu(){timespec t;clock_gettime(CLOCK_PROCESS_CPUTIME_ID,&t);return 1e3*t.tv_sec+1e-6*t.tv_nsec;}
int main(int argc,char**argv){
  VirtualDisplay* d=nullptr; (void)d;
  WindowApplication app;
  TrialSetup setup; setup.patient=argv[1]; setup.curriculum=curricula_folder()/"first-intubation.yaml"; setup.scenario="term-tube"; setup.device="scripted:expert"; setup.out="/tmp/probe_out"; setup.realtime=false;
  TrialSession s(setup);
  QElapsedTimer lt; lt.start();
  auto look=make_patient_look(s.package(),{},Seen::from_the_eye,argv[1]);
  printf("look %lld ms\n",(long long)lt.elapsed());
  QWidget w; auto* v=new OperatorView(&w); auto* l=new QVBoxLayout(&w); l->addWidget(v); w.resize(790,600);
  v->show_patient(look,s.scene().tool.surface,&*s.scene().intubation);
  w.show(); int swaps=0; QObject::connect(v,&QOpenGLWidget::frameSwapped,&w,[&]{++swaps;});
  v->set_zoom(OperatorView::Zoom::mouth);
  s.start(); engine::Snapshot snap; while(!s.finished()){ const auto& n=s.latest(); if(n.time_s>9.0){snap=n;break;} }
  GlView::governor().hold(argc>2?atoi(argv[2]):0);
  auto frame=[&](bool upd){ int b=swaps; double c=cpu(); if(upd) v->update_from(snap); v->draw(); QElapsedTimer t;t.start(); while(swaps==b&&t.elapsed()<1000) QApplication::processEvents(QEventLoop::AllEvents,5); return cpu()-c; };
  auto avg=[&](bool upd){ for(int i=0;i<3;i++) frame(upd); double a=0; for(int i=0;i<10;i++) a+=frame(upd); return a/10; };
  s.finish("x");
  v->update_from(snap); v->settle();
  printf("with update %.1f\n",avg(true)); printf("without update %.1f\n",avg(false));
  auto* ren=vtkRenderer::SafeDownCast(v->renderWindow()->GetRenderers()->GetItemAsObject(0));
  auto* actors=ren->GetActors(); actors->InitTraversal(); std::vector<vtkActor*> all; while(auto* a=actors->GetNextActor()) all.push_back(a);
  for(auto* a:all){ if(!a->GetVisibility()) continue; auto* pd=vtkPolyData::SafeDownCast(a->GetMapper()->GetInput()); a->VisibilityOff(); double t=avg(false); printf("without actor pts %lld polys %lld: %.1f\n",(long long)(pd?pd->GetNumberOfPoints():0),(long long)(pd?pd->GetNumberOfPolys():0),t); a->VisibilityOn(); }
  for(auto* a:all) a->VisibilityOff(); printf("nothing %.1f\n",avg(false));
  return 0; }
