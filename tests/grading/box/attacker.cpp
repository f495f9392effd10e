// Does what its first argument says, which is what no program may do in the box. It prints what
// came of it, and exits with 0 if the attack has worked.
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

std::vector<std::string> arguments;

bool told(bool worked, const char* what) {
  if (worked) std::printf("%s\n", what);
  return worked;
}

/// Any byte of any of the files; folders by their entries.
bool reads() {
  bool any = false;
  for (const auto& path : arguments) {
    const int file = open(path.c_str(), O_RDONLY);
    any |= told(file >= 0, path.c_str());
  }
  return any;
}

bool writes() {
  bool any = false;
  for (const auto& path : arguments) {
    any |= told(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600) >= 0, path.c_str());
    any |= told(unlink(path.c_str()) == 0, "unlinked");
    any |= told(symlink("/etc/passwd", (path + ".link").c_str()) == 0, "symlink");
    any |= told(chmod(path.c_str(), 0777) == 0, "chmod");
    any |= told(rename(path.c_str(), (path + ".old").c_str()) == 0, "renamed");
  }
  return any;
}

bool connects() {
  const int inet = socket(AF_INET, SOCK_STREAM, 0);
  const int unix_socket = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_in local{};
  local.sin_family = AF_INET;
  local.sin_port = htons(static_cast<std::uint16_t>(std::stoi(arguments.at(0))));
  local.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  bool any = told(inet >= 0, "socket");
  any |= told(unix_socket >= 0, "unix socket");
  any |= told(inet >= 0 && connect(inet, reinterpret_cast<sockaddr*>(&local), sizeof(local)) == 0,
              "connected");
  return any;
}

bool kills() {
  bool any = false;
  for (const auto& pid : arguments) any |= kill(std::stoi(pid), SIGKILL) == 0;
  return any;
}

/// Its supervisor, and all that it may reach.
bool kills_around() {
  signal(SIGTERM, SIG_IGN);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR1, SIGSTOP, SIGKILL}) {
    kill(getppid(), signal);
    syscall(SYS_tkill, getppid(), signal);
  }
  kill(-1, SIGTERM);
  return false;
}

bool forks_for_ever() {
  int children = 0;
  for (int tries = 0; tries < 3000; ++tries) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) {
        if (fork() < 0) usleep(1000);
      }
    }
    if (child > 0) ++children;
    if (child < 0) usleep(1000);
  }
  return told(children > 100, "forked");
}

/// A chain: each process ends as soon as it has made the next.
bool hops() {
  if (fork() > 0) pause();
  for (long i = 0;; ++i) {
    const pid_t child = fork();
    if (child > 0) _exit(0);
    if (child < 0) usleep(100);
  }
}

void take(std::size_t bytes) {
  auto* memory = static_cast<volatile char*>(
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  if (memory == MAP_FAILED) _exit(3);
  for (std::size_t i = 0; i < bytes; i += 4096) memory[i] = 1;
}

bool takes_memory() {
  take(std::size_t{1} << 30);
  return true;
}

bool takes_memory_in_many() {
  for (int i = 0; i < 10; ++i) {
    if (fork() == 0) {
      take(std::size_t{120} << 20);
      pause();
      _exit(0);
    }
  }
  sleep(3);
  return true;
}

void spin() {
  volatile bool for_ever = true;
  while (for_ever) {
  }
}

bool spins() {
  signal(SIGXCPU, SIG_IGN);
  spin();
  return true;
}

/// A second of each of many processes that nobody waits for.
bool spins_in_many() {
  signal(SIGCHLD, SIG_IGN);
  for (int i = 0; i < 1000; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      const rlimit little{1, 1};
      setrlimit(RLIMIT_CPU, &little);
      spin();
    }
    while (child > 0 && kill(child, 0) == 0) usleep(1000);
    if (child < 0) usleep(1000);
  }
  return true;
}

/// No attack: half a second of processor time.
bool computes() {
  const clock_t end = clock() + CLOCKS_PER_SEC / 2;
  while (clock() < end) {
  }
  return true;
}

bool sleeps() {
  pause();
  return true;
}

bool dozes() {
  for (;;) usleep(2000);
}

bool floods() {
  const std::string line(4096, 'x');
  for (;;) {
    if (write(1, line.data(), line.size()) < 0) return false;
  }
}

/// A process that stays and writes later.
bool stays() {
  if (fork() == 0) {
    setsid();
    setpgid(0, 0);
    if (fork() == 0) {
      prctl(PR_SET_NAME, arguments.at(0).c_str());
      for (int i = 3; i < 10; ++i) close(i);
      sleep(60);
    }
    _exit(0);
  }
  usleep(50'000);
  return true;
}

bool traces() {
  bool any = told(ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0, "ptrace");
  any |= told(ptrace(PTRACE_TRACEME, 0, 0, 0) == 0, "traceme");
  char byte = 0;
  const iovec local{&byte, 1};
  const iovec remote{&byte, 1};
  any |= told(syscall(SYS_process_vm_readv, getppid(), &local, 1, &remote, 1, 0) >= 0, "vm_readv");
  const std::string parent = "/proc/" + std::to_string(getppid());
  for (const char* what : {"/mem", "/environ", "/maps", "/fd/4", "/fd/0", "/root/etc", "/cwd/x"}) {
    any |= told(
        open((parent + what).c_str(), O_RDWR) >= 0 || open((parent + what).c_str(), O_RDONLY) >= 0,
        what);
  }
  return any;
}

bool makes_namespaces() {
  bool any = told(unshare(CLONE_NEWUSER) == 0, "unshare");
  any |= told(syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0) > 0, "clone");
  any |= told(syscall(SYS_io_uring_setup, 1, nullptr) >= 0, "io_uring");
  any |= told(syscall(SYS_memfd_create, "x", 0) >= 0, "memfd");
  any |= told(shmget(IPC_PRIVATE, 4096, 0600) >= 0, "shm");
  any |= told(setpriority(PRIO_PROCESS, static_cast<id_t>(getppid()), 19) == 0, "priority");
  return any;
}

bool limits_others() {
  const rlimit none{0, 0};
  bool any = false;
  for (const auto& pid : arguments) {
    any |= told(prlimit(std::stoi(pid), RLIMIT_NOFILE, &none, nullptr) == 0, "prlimit");
  }
  return any;
}

bool writes_a_huge_file() {
  signal(SIGXFSZ, SIG_IGN);
  const int file = open("huge", O_WRONLY | O_CREAT, 0600);
  const std::string block(1 << 20, 'x');
  std::size_t written = 0;
  while (written < (std::size_t{1} << 30)) {
    const ssize_t count = write(file, block.data(), block.size());
    if (count <= 0) break;
    written += static_cast<std::size_t>(count);
  }
  std::printf("%zu\n", written);
  return written > (std::size_t{64} << 20);
}

bool writes_many_files() {
  for (int i = 0; i < 200'000; ++i) {
    const int file = open(("f" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
    if (file < 0) return false;
    close(file);
  }
  return true;
}

/// Files outside, and what nobody counts: other places in memory.
bool fills_memory_files() {
  bool any = false;
  for (const char* folder : {"/", "/dev", "/dev/shm", "/run", "/box", "/usr", "/var/tmp"}) {
    const std::string path = std::string(folder) + "/fos-attack";
    any |= told(open(path.c_str(), O_WRONLY | O_CREAT, 0600) >= 0, path.c_str());
    unlink(path.c_str());
  }
  return any;
}

bool lists_descriptors() {
  bool any = false;
  for (int i = 4; i < 1024; ++i) any |= told(fcntl(i, F_GETFD) >= 0, std::to_string(i).c_str());
  return any;
}

bool lists_environment() {
  bool any = false;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string word = *entry;
    if (word.starts_with("PATH=") || word.starts_with("HOME=") || word.starts_with("LC_ALL=") ||
        word.starts_with("TMPDIR=") || word.starts_with("PWD=")) {
      continue;
    }
    any |= told(true, *entry);
  }
  return any;
}

bool sees_processes() {
  bool any = false;
  for (const auto& pid : arguments) {
    any |= told(open(("/proc/" + pid + "/cmdline").c_str(), O_RDONLY) >= 0, pid.c_str());
  }
  return any;
}

const std::map<std::string, std::function<bool()>> attacks{
    {"reads", reads},
    {"writes", writes},
    {"connects", connects},
    {"kills", kills},
    {"kills around", kills_around},
    {"forks for ever", forks_for_ever},
    {"hops", hops},
    {"takes memory", takes_memory},
    {"takes memory in many", takes_memory_in_many},
    {"spins", spins},
    {"spins in many", spins_in_many},
    {"computes", computes},
    {"sleeps", sleeps},
    {"dozes", dozes},
    {"floods", floods},
    {"stays", stays},
    {"traces", traces},
    {"makes namespaces", makes_namespaces},
    {"limits others", limits_others},
    {"writes a huge file", writes_a_huge_file},
    {"writes many files", writes_many_files},
    {"fills memory files", fills_memory_files},
    {"lists descriptors", lists_descriptors},
    {"lists environment", lists_environment},
    {"sees processes", sees_processes},
    {"aborts", []() -> bool { std::abort(); }},
    {"aborts in a child",
     [] {
       const pid_t child = fork();
       if (child == 0) std::abort();
       int status = 0;
       waitpid(child, &status, 0);
       return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
     }},
    {"exits with 134", []() -> bool { _exit(134); }},
    {"nothing", [] { return true; }},
};

}  // namespace

int main(int count, char** words) {
  setvbuf(stdout, nullptr, _IONBF, 0);
  if (count < 2) return 2;
  arguments.assign(words + 2, words + count);
  return attacks.at(words[1])() ? 0 : 1;
}
