// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd batch`: many inputs, each in a process of its own, so that none can stop the others.

#include "Batch_manifest.h"
#include "commands.h"
#include "memory.h"
#include <CSCD/exceptions.h>
#include <CSCD/internal/counted.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <deque>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

/// What stands for the name of the output files, without an ending.
constexpr const char* placeholder = "{}";
/// Exit status of a child that could not become the program; the program has 0 to 3.
constexpr int not_started = 127;
/// That of the program for an internal failure, memory included.
constexpr int internal_failure = 3;

/// An input and where its results go.
struct Task
{
  std::string input;
  fs::path output; ///< in the output folder, without an ending
};

/// A part of the inputs: every `number`-th, from `index` on.
struct Part
{
  std::size_t index = 0;
  std::size_t number = 1;

  std::string suffix() const
  {
    return number == 1 ? "" : "_" + std::to_string(index + 1) + "_of_" + std::to_string(number);
  }
};

Part parse_part(const std::string& text)
{
  if (text.empty()) {
    return {};
  }
  std::istringstream in(text);
  std::size_t index = 0;
  std::size_t number = 0;
  char slash = 0;
  const bool has_digits_only = text.find_first_not_of("0123456789/") == std::string::npos;
  if (!has_digits_only || !(in >> index >> slash >> number) || slash != '/' || !in.eof() || index < 1 ||
      index > number) {
    throw Usage_error("--part: must be I/N with I from 1 to N, as in 3/8, not " + text);
  }
  return {index - 1, number};
}

void append_lines(std::istream& in, std::vector<std::string>& lines)
{
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') {
      line.pop_back();
    }
    if (!line.empty()) {
      lines.push_back(line);
    }
  }
}

std::vector<std::string> all_inputs(const Batch_options& options)
{
  std::vector<std::string> result = options.inputs;
  if (options.list == standard_stream) {
    append_lines(std::cin, result);
  } else if (!options.list.empty()) {
    std::ifstream in(options.list);
    if (!in) {
      throw CSCD::File_error(options.list + ": cannot be opened; check the name and the permissions");
    }
    append_lines(in, result);
  }
  if (result.empty()) {
    throw Usage_error("there are no inputs; name files, or a list of them by --list");
  }
  return result;
}

/// The folder that all `paths` are in.
fs::path common_folder(const std::vector<fs::path>& paths)
{
  fs::path result = paths.front().parent_path();
  for (const fs::path& path : paths) {
    const fs::path folder = path.parent_path();
    const auto end = std::mismatch(result.begin(), result.end(), folder.begin(), folder.end()).first;
    fs::path common;
    for (auto part = result.begin(); part != end; ++part) {
      common /= *part;
    }
    result = common;
  }
  return result;
}

/// The inputs, each once, with outputs that lie to each other as the inputs do.
/// \throw Usage_error if two have the same output
std::vector<Task> make_tasks(const std::vector<std::string>& inputs)
{
  std::vector<fs::path> paths;
  paths.reserve(inputs.size());
  for (const std::string& input : inputs) {
    paths.push_back(fs::absolute(input).lexically_normal());
  }
  const fs::path folder = common_folder(paths);
  std::vector<Task> result;
  std::unordered_map<std::string, std::size_t> input_of_output;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const fs::path output = paths[i].lexically_relative(folder).replace_extension();
    const auto [other, is_new] = input_of_output.emplace(output.string(), i);
    if (is_new) {
      result.push_back({inputs[i], output});
    } else if (paths[other->second] != paths[i]) {
      throw Usage_error(inputs[other->second] + " and " + inputs[i] +
                        ": differ in the ending only, so that their results would have one name; use two folders");
    }
  }
  return result;
}

bool has_option(const std::vector<std::string>& options, const std::vector<std::string>& names)
{
  return std::any_of(options.begin(), options.end(), [&](const std::string& option) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return option == name || option.rfind(name + "=", 0) == 0; });
  });
}

/// Refuses options of `cscd skeletonize` by which all inputs would write to one file.
void check_output_options(const std::vector<std::string>& options)
{
  constexpr std::array<const char*, 8> outputs{"-o",      "--output",         "--html",     "--branches",
                                               "--nodes", "--correspondence", "--labelled", "--cylinders"};
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string name = options[i].substr(0, options[i].find('='));
    const bool is_output = std::find(outputs.begin(), outputs.end(), name) != outputs.end();
    const std::string& value = name == options[i] && i + 1 < options.size() ? options[i + 1] : options[i];
    if (is_output && value.find(placeholder) == std::string::npos) {
      throw Usage_error(name + ": name one file for all inputs; write {} for the name of each, as in -o {}.swc");
    }
  }
}

/// Puts the name of the output files of `options`, and what every process needs, in its place.
std::vector<std::string> check_command_options(std::vector<std::string> options)
{
  const bool has_placeholder = std::any_of(options.begin(), options.end(), [](const std::string& option) {
    return option.find(placeholder) != std::string::npos;
  });
  if (has_option(options, {"--report"})) {
    throw Usage_error("--report: the manifest has the counts; leave it out");
  }
  check_output_options(options);
  if (!has_placeholder) {
    options.insert(options.end(), {"-o", std::string(placeholder) + ".graph"});
  }
  if (!has_option(options, {"--threads"})) {
    options.insert(options.end(), {"--threads", "1"});
  }
  return options;
}

std::string replace_placeholders(std::string text, const std::string& name)
{
  const std::size_t length = std::strlen(placeholder);
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at + name.size())) {
    text.replace(at, length, name);
  }
  return text;
}

std::string content_of(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The last line of what the program wrote to standard error, without its name in front.
std::string last_message(std::string text)
{
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  text.erase(0, text.rfind('\n') + 1); // all of it if there is one line only
  const std::string prefix = "cscd: ";
  return text.rfind(prefix, 0) == 0 ? text.substr(prefix.size()) : text;
}

/// Signals that the batch waits for: the end of a child, and those that end the batch, unless whoever started it wants
/// them ignored, as `nohup` does.
sigset_t awaited_signals()
{
  sigset_t result;
  sigemptyset(&result);
  sigaddset(&result, SIGCHLD);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) {
      sigaddset(&result, signal);
    }
  }
  return result;
}

/// A process that works on a task, in a folder of its own.
struct Job
{
  Task task;
  fs::path folder;
  Clock::time_point begin;
  bool is_overdue = false;
};

/// Runs tasks in processes until all are done or a signal comes.
class Batch_run
{
public:
  Batch_run(const Batch_options& options, const Part& part)
      : m_options(options), m_command_options(check_command_options(options.command_options)),
        m_output_folder(options.output_folder), m_work_folder(m_output_folder / (".cscd_batch" + part.suffix())),
        m_manifest((m_output_folder / ("manifest" + part.suffix() + ".csv")).string(), options.resumes),
        m_signals(awaited_signals())
  {
    fs::remove_all(m_work_folder); // of a batch that was killed
    fs::create_directory(m_work_folder);
  }
  Batch_run(const Batch_run&) = delete;
  Batch_run& operator=(const Batch_run&) = delete;
  ~Batch_run()
  {
    for (const auto& [process, job] : m_jobs) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
    }
    std::error_code error;
    fs::remove_all(m_work_folder, error);
  }

  bool has(const Task& task) const { return m_manifest.has(task.input); }

  /// \return the signal that ended it, or 0
  int run(std::deque<Task> tasks)
  {
    std::signal(SIGCHLD, SIG_DFL); // if it is ignored, nobody can wait for children
    sigprocmask(SIG_BLOCK, &m_signals, &m_child_signals);
    const std::size_t number_of_jobs = m_options.number_of_jobs > 0
                                           ? m_options.number_of_jobs
                                           : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    int signal = 0;
    while (signal == 0 && (!tasks.empty() || !m_jobs.empty())) {
      while (!tasks.empty() && m_jobs.size() < number_of_jobs) {
        start(tasks.front());
        tasks.pop_front();
      }
      signal = wait_for_signal();
      if (signal == 0 && !is_signal_pending()) {
        stop_overdue_jobs();
        finish_ended_jobs();
      }
    }
    return signal;
  }

  /// Of the rows that were added, by status.
  const std::map<std::string, std::size_t>& numbers() const { return m_numbers; }
  std::size_t number_of(const std::string& status) const
  {
    const auto found = m_numbers.find(status);
    return found != m_numbers.end() ? found->second : 0;
  }

private:
  void start(const Task& task)
  {
    Job job{task, m_work_folder / std::to_string(m_number_of_starts++), Clock::now()};
    fs::create_directories(job.folder / "files");
    const std::vector<std::string> arguments = arguments_of(job);
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) {
      pointers.push_back(const_cast<char*>(argument.c_str())); // exec has no const, and changes nothing
    }
    pointers.push_back(nullptr);
    const std::string messages = (job.folder / "messages").string();
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0) {
      throw CSCD::File_error(std::string("no process can be started (") + std::strerror(errno) +
                             "); end others, or lower --jobs");
    }
    if (process == 0) {
      become_program(pointers.data(), messages.c_str(), parent);
    }
    m_jobs.emplace(process, std::move(job));
  }

  std::vector<std::string> arguments_of(const Job& job) const
  {
    const std::string name = (job.folder / "files" / job.task.output.filename()).string();
    std::vector<std::string> result{"cscd", "skeletonize", "--quiet", "--report", (job.folder / "report").string()};
    for (const std::string& option : m_command_options) {
      result.push_back(replace_placeholders(option, name));
    }
    result.insert(result.end(), {"--", job.task.input});
    return result;
  }

  /// In the child: only what may be called between fork and exec.
  [[noreturn]] void become_program(char** arguments, const char* messages, pid_t parent) const
  {
    constexpr mode_t permissions = 0600;
    const int out = open("/dev/null", O_RDWR);
    const int err = open(messages, O_WRONLY | O_CREAT | O_TRUNC, permissions);
    dup2(out, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    setpgid(0, 0);                    // signals of a terminal are for the batch
    prctl(PR_SET_PDEATHSIG, SIGKILL); // no child outlives a batch that is killed
    if (m_options.memory > 0) {
      limit_memory(m_options.memory);
    }
    sigprocmask(SIG_SETMASK, &m_child_signals, nullptr);
    if (getppid() == parent) {
      execv("/proc/self/exe", arguments);
    }
    _exit(not_started);
  }

  /// Waits for the end of a child, a signal, or the time at which the first job is overdue.
  /// \return the signal that ends the batch, or 0
  int wait_for_signal() const
  {
    siginfo_t info;
    int signal = 0;
    if (m_options.timeout > 0) {
      constexpr double longest_wait = 1e6; // seconds: any number that the system's type can hold
      double rest = std::min(m_options.timeout, longest_wait);
      for (const auto& [process, job] : m_jobs) {
        rest = job.is_overdue ? rest : std::min(rest, m_options.timeout - seconds_since(job.begin));
      }
      constexpr double nanoseconds = 1e9; // in a second
      const double whole = std::floor(std::max(0., rest));
      const timespec time{time_t(whole), long((std::max(0., rest) - whole) * nanoseconds)};
      signal = sigtimedwait(&m_signals, &info, &time);
    } else {
      signal = sigwaitinfo(&m_signals, &info);
    }
    return signal > 0 && signal != SIGCHLD ? signal : 0;
  }

  /// Whether the batch is to end: the children may have ended of the same signal, which is no fault of their inputs.
  static bool is_signal_pending()
  {
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1 ||
           sigismember(&pending, SIGHUP) == 1;
  }

  static double seconds_since(Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  void stop_overdue_jobs()
  {
    for (auto& [process, job] : m_jobs) {
      if (m_options.timeout > 0 && !job.is_overdue && seconds_since(job.begin) >= m_options.timeout) {
        job.is_overdue = true;
        kill(process, SIGKILL);
      }
    }
  }

  /// One signal may stand for the end of several children.
  void finish_ended_jobs()
  {
    int status = 0;
    rusage usage{};
    for (pid_t process = wait4(-1, &status, WNOHANG, &usage); process > 0;
         process = wait4(-1, &status, WNOHANG, &usage)) {
      const auto job = m_jobs.find(process);
      if (job != m_jobs.end()) {
        finish(job->second, status, usage);
        m_jobs.erase(job);
      }
    }
  }

  void finish(const Job& job, int status, const rusage& usage)
  {
    constexpr double kilobytes_a_megabyte = 1024;
    Batch_row row;
    row.input = job.task.input;
    row.seconds = seconds_since(job.begin);
    row.megabytes = double(usage.ru_maxrss) / kilobytes_a_megabyte;
    row.message = last_message(content_of(job.folder / "messages"));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
      row.status = done_status;
      read_report(job.folder / "report", row);
      move_files(job);
    } else if (job.is_overdue) {
      row.status = timeout_status;
      row.message = "no skeleton after the time of --timeout";
    } else if (WIFSIGNALED(status)) {
      row.status = crashed_status;
      row.message = "ended by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
    } else if (WEXITSTATUS(status) == internal_failure && row.message.rfind("not enough memory", 0) == 0) {
      row.status = memory_status;
    } else {
      const bool is_refused = WEXITSTATUS(status) > 0 && WEXITSTATUS(status) < internal_failure;
      row.status = is_refused ? failed_status : crashed_status;
    }
    row.message = printable(row.message);
    fs::remove_all(job.folder);
    m_manifest.append(row);
    ++m_numbers[row.status];
  }

  /// Puts counts and sentences of the report of a skeletonization into `row`.
  static void read_report(const fs::path& filename, Batch_row& row)
  {
    const nlohmann::json report = nlohmann::json::parse(content_of(filename), nullptr, false);
    for (const char* count : batch_counts) {
      row.counts.push_back(report.contains(count) ? report[count].dump() : "");
    }
    row.message.clear();
    if (!report.is_object()) {
      return;
    }
    for (const char* sentences : {"repairs", "warnings"}) {
      for (const auto& sentence : report.value(sentences, nlohmann::json::array())) {
        row.message += (row.message.empty() ? "" : "; ") + sentence.get<std::string>();
      }
    }
  }

  /// Only now do files appear where users look for them.
  void move_files(const Job& job) const
  {
    const fs::path folder = m_output_folder / job.task.output.parent_path();
    fs::create_directories(folder);
    for (const fs::directory_entry& file : fs::directory_iterator(job.folder / "files")) {
      fs::rename(file.path(), folder / file.path().filename());
    }
  }

  const Batch_options& m_options;
  std::vector<std::string> m_command_options;
  fs::path m_output_folder;
  fs::path m_work_folder; ///< in the output folder: files can be moved from there without being copied
  Batch_manifest m_manifest;
  sigset_t m_signals;
  sigset_t m_child_signals{};
  std::map<pid_t, Job> m_jobs;
  std::size_t m_number_of_starts = 0;
  std::map<std::string, std::size_t> m_numbers;
};

void write_summary(std::size_t number_of_tasks, std::size_t number_of_earlier_tasks,
                   const std::map<std::string, std::size_t>& numbers)
{
  std::cout << CSCD::internal::counted(number_of_tasks, "input");
  if (number_of_earlier_tasks > 0) {
    std::cout << ", " << number_of_earlier_tasks << " in the manifest already";
  }
  for (const auto& [status, number] : numbers) {
    std::cout << ", " << number << ' ' << status;
  }
  std::cout << '\n';
}

} // namespace

bool batch(const Batch_options& options)
try {
  const Part part = parse_part(options.part);
  const std::vector<Task> all_tasks = make_tasks(all_inputs(options));
  fs::create_directories(options.output_folder);
  int signal = 0;
  bool is_all_done = false;
  { // cleans up at its end
    Batch_run run(options, part);
    std::size_t number_of_tasks = 0;
    std::deque<Task> tasks;
    for (std::size_t i = part.index; i < all_tasks.size(); i += part.number) {
      ++number_of_tasks;
      if (!run.has(all_tasks[i])) {
        tasks.push_back(all_tasks[i]);
      }
    }
    const std::size_t number_of_new_tasks = tasks.size();
    signal = run.run(std::move(tasks));
    is_all_done = run.number_of(done_status) == number_of_new_tasks;
    if (!options.is_quiet) {
      write_summary(number_of_tasks, number_of_tasks - number_of_new_tasks, run.numbers());
    }
  }
  if (signal != 0) { // so that whoever started this knows why it ended
    std::signal(signal, SIG_DFL);
    const sigset_t signals = awaited_signals();
    raise(signal);
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
  }
  return is_all_done;
} catch (const fs::filesystem_error& error) {
  throw CSCD::File_error(std::string(error.what()) + "; check the folder, its permissions and the disk");
}

} // namespace cscd
