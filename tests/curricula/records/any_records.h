// What must hold of the records whatever keeps them: a SQLite file or a real PostgreSQL server.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "curricula/records/records.h"
#include "tests/curricula/records/postgres_server.h"
#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula::testing {

enum class Kept { sqlite, postgres };

/// Every test finds an empty database at location().
class AnyRecords : public ::testing::TestWithParam<Kept> {
 protected:
  void SetUp() override;
  void TearDown() override;
  bool on_server() const { return GetParam() == Kept::postgres; }
  const RecordsLocation& location() const { return *location_; }
  RecordsLocation at_station(const std::string& station) const;
  /// Beside the code under test: the first line of what the database answers.
  std::string ask(const std::string& sql) const;

  std::filesystem::path folder_;
  std::string setting_;

 private:
  std::unique_ptr<RecordsLocation> location_;
};

RecordRow sample(const std::string& when);
void expect_same(const RecordRow& a, const RecordRow& b);

}  // namespace vallecula::curricula::testing
