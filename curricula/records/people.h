// Trainees and instructors: who they are, their PINs, who may do what.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::curricula {

enum class Role { trainee, instructor };

struct Person {
  long long id = 0;  ///< never given twice
  Role role = Role::trainee;
  std::string name;  ///< or pseudonym; unique
  std::string created_utc;
};

/// Proof that a person gave the PIN: only People makes one. Whether the person still exists and is an instructor is
/// asked of the database each time it is used.
class SignedIn {
 public:
  long long id() const { return id_; }

 private:
  friend class People;
  explicit SignedIn(long long id) : id_(id) {}
  long long id_;
};
/// Empty: nobody is signed in.
using Who = std::optional<SignedIn>;

class NotAllowed : public RecordsError {
 public:
  using RecordsError::RecordsError;
};

/// The PIN was wrong, or is not looked at because of earlier wrong ones.
class PinRefused : public RecordsError {
 public:
  PinRefused(const std::string& message, double wait) : RecordsError(message), wait_s(wait) {}
  double wait_s;  ///< until the next try is looked at; 0: at once
};

struct AuditEntry {
  long long id = 0;
  std::string at_utc;
  long long actor_id = 0;  ///< 0: nobody was signed in
  std::string action;      ///< "trainee registered", "signed in", "person deleted", ...
  long long subject_id = 0;
};

/// Uses the connection of `records`, which must outlive it. Every call throws RecordsError; what the caller may not do,
/// NotAllowed. A name has 1 to 100 characters, none of them a control character; a PIN 4 to 64.
class People {
 public:
  explicit People(Records& records) : records_(records) {}

  bool has_instructor() const;
  /// At first use. NotAllowed once there is one, also when two stations try at once.
  SignedIn create_first_instructor(const std::string& name, const std::string& pin);
  long long create_instructor(const SignedIn& instructor, const std::string& name, const std::string& pin);
  /// By anybody, for themselves: whoever practises alone needs no instructor.
  long long register_trainee(const std::string& name, const std::string& pin);
  std::vector<Person> list() const;  ///< by name

  /// Throws PinRefused. Three wrong PINs in a row make one wait, longer each time, by the clock all stations share; a
  /// PIN is counted as wrong before it is looked at, so that neither a killed program nor many at once gain tries.
  SignedIn sign_in(long long id, const std::string& pin);
  void change_pin(const SignedIn& who, const std::string& old_pin, const std::string& new_pin);
  void reset_pin(const SignedIn& instructor, long long id, const std::string& new_pin);  ///< ends a wait as well
  void rename(const SignedIn& who, long long id, const std::string& name);  ///< oneself, or an instructor anybody

  /// The newest `count`, newest first; instructors only.
  std::vector<AuditEntry> audit(const SignedIn& instructor, int count) const;

 private:
  long long create(Role role, const std::string& name, const std::string& hash, long long actor, const char* action);

  Records& records_;
};

}  // namespace vallecula::curricula
