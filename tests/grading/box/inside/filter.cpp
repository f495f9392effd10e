#include "filter.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "landlock.hpp"

namespace fos::grading::inside {
namespace {

// Of a stage or a compiler nobody asks for these. They reach other processes, the network, the
// kernel's larger and younger parts, or memory that nobody counts.
constexpr int denied[] = {
    // other processes
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_process_madvise,
    SYS_kcmp,
    SYS_pidfd_open,
    SYS_pidfd_getfd,
    SYS_pidfd_send_signal,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_setpriority,
    SYS_sched_setscheduler,
    SYS_sched_setparam,
    SYS_sched_setattr,
    SYS_sched_setaffinity,
    SYS_ioprio_set,
    SYS_migrate_pages,
    SYS_move_pages,
    // out of the session, by which the supervisor knows them
    SYS_setsid,
    SYS_setpgid,
    // whose a file is and who may use it, which Landlock leaves open
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_utimensat,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_truncate,
#ifdef SYS_chmod
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
#endif
    // the network, and talk with other processes
    SYS_socket,
    SYS_socketpair,
    SYS_mq_open,
    SYS_mq_unlink,
    // memory that belongs to no process
    SYS_memfd_create,
    SYS_shmget,
    SYS_shmat,
    SYS_shmctl,
    SYS_semget,
    SYS_semctl,
    SYS_semop,
    SYS_semtimedop,
    SYS_msgget,
    SYS_msgsnd,
    SYS_msgrcv,
    SYS_msgctl,
    SYS_add_key,
    SYS_request_key,
    SYS_keyctl,
    // namespaces and mounts
    SYS_unshare,
    SYS_setns,
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_move_mount,
    SYS_open_tree,
    SYS_fsopen,
    SYS_fsconfig,
    SYS_fsmount,
    SYS_fspick,
    SYS_name_to_handle_at,
    SYS_open_by_handle_at,
    SYS_fanotify_init,
    // large doors into the kernel
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_io_setup,
    // the machine
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_acct,
    SYS_quotactl,
    SYS_syslog,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_adjtimex,
    SYS_clock_adjtime,
    SYS_vhangup,
#ifdef SYS_mount_setattr
    SYS_mount_setattr,
#endif
#ifdef SYS_quotactl_fd
    SYS_quotactl_fd,
#endif
#ifdef SYS_memfd_secret
    SYS_memfd_secret,
#endif
#ifdef SYS_process_mrelease
    SYS_process_mrelease,
#endif
#ifdef SYS_kexec_file_load
    SYS_kexec_file_load,
#endif
#ifdef SYS_modify_ldt
    SYS_modify_ldt,
#endif
#ifdef SYS_iopl
    SYS_iopl,
    SYS_ioperm,
#endif
};

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
constexpr std::uint32_t first_foreign = 0x40000000;  // the x32 calls have this bit
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
constexpr std::uint32_t first_foreign = 0;
#else
#error "the box knows the system calls of x86-64 and of aarch64 only"
#endif

constexpr std::uint32_t allow = SECCOMP_RET_ALLOW;
constexpr std::uint32_t refuse = SECCOMP_RET_ERRNO | EPERM;
constexpr std::uint32_t not_there = SECCOMP_RET_ERRNO | ENOSYS;

/// The program for the kernel's filter, in the making. Each rule loads what it looks at itself.
class Filter {
 public:
  void load(std::size_t offset) {
    code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
  }
  void answer(std::uint32_t what) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, what)); }
  /// Goes over the next `count` statements unless the loaded word is `value`.
  void skip_unless(std::uint32_t value, std::uint8_t count) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, count));
  }
  void skip_if(std::uint32_t value, std::uint8_t count) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, count, 0));
  }
  void skip_unless_any(std::uint32_t bits, std::uint8_t count) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, 0, count));
  }
  void skip_if_less(std::uint32_t value, std::uint8_t count) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, value, 0, count));
  }

  void load_call() { load(offsetof(seccomp_data, nr)); }
  /// The lower half of an argument, in which pids, signals, flags and commands are.
  void load_argument(std::size_t index) {
    const std::size_t low = std::endian::native == std::endian::little ? 0 : 4;
    load(offsetof(seccomp_data, args) + index * sizeof(std::uint64_t) + low);
  }

  void always(int call, std::uint32_t what) {
    skip_unless(static_cast<std::uint32_t>(call), 1);
    answer(what);
  }
  /// The call is refused unless this argument is `value`.
  void only_with(int call, std::size_t index, std::uint32_t value) {
    skip_unless(static_cast<std::uint32_t>(call), 4);
    load_argument(index);
    skip_if(value, 1);
    answer(refuse);
    load_call();
  }
  /// The call is refused where this argument is `value`.
  void never_with(int call, std::size_t index, std::uint32_t value) {
    skip_unless(static_cast<std::uint32_t>(call), 4);
    load_argument(index);
    skip_unless(value, 1);
    answer(refuse);
    load_call();
  }
  void never_with_any(int call, std::size_t index, std::uint32_t bits) {
    skip_unless(static_cast<std::uint32_t>(call), 4);
    load_argument(index);
    skip_unless_any(bits, 1);
    answer(refuse);
    load_call();
  }

  bool install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
  }

 private:
  std::vector<sock_filter> code_;
};

/// No signal to anyone else: where others of this user are in reach, and neither the kernel's
/// namespaces nor Landlock keep signals in.
void keep_signals(Filter& filter) {
  const auto self = static_cast<std::uint32_t>(getpid());
  filter.only_with(SYS_kill, 0, self);
  filter.only_with(SYS_tgkill, 0, self);
  filter.always(SYS_tkill, refuse);
  constexpr std::uint32_t set_signal = 10;    // F_SETSIG
  constexpr std::uint32_t set_owner_ex = 15;  // F_SETOWN_EX
  for (const std::uint32_t command : {std::uint32_t{F_SETOWN}, set_signal, set_owner_ex}) {
    filter.never_with(SYS_fcntl, 1, command);
  }
  constexpr std::uint32_t owner_of_socket[] = {0x8901, 0x8902};  // FIOSETOWN, SIOCSPGRP
  for (const std::uint32_t command : owner_of_socket) filter.never_with(SYS_ioctl, 1, command);
}

}  // namespace

bool filter_calls(const Settings& settings) {
  Filter filter;
  filter.load(offsetof(seccomp_data, arch));
  filter.skip_if(architecture, 1);
  filter.answer(SECCOMP_RET_KILL_PROCESS);
  filter.load_call();
  if (first_foreign != 0) {
    filter.skip_if_less(first_foreign, 1);
    filter.answer(SECCOMP_RET_KILL_PROCESS);
  }
  for (const int call : denied) filter.always(call, refuse);
  constexpr int change_mode = 452;  // fchmodat2, younger than the distribution's headers
  filter.always(change_mode, not_there);
  filter.always(SYS_clone3, not_there);  // its flags are out of sight; glibc then takes clone
  filter.never_with_any(SYS_clone, 0,
                        CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC |
                            CLONE_NEWUTS | CLONE_NEWCGROUP);
  filter.only_with(SYS_prlimit64, 0, 0);                // its own limits only
  constexpr std::uint32_t typing[] = {0x5412, 0x541C};  // TIOCSTI, TIOCLINUX
  for (const std::uint32_t command : typing) filter.never_with(SYS_ioctl, 1, command);
  const bool kept_by_kernel =
      settings.landlock && landlock_version(settings.landlock_abi) >= landlock_with_signals;
  if (settings.shared_user && !kept_by_kernel) keep_signals(filter);
  filter.answer(allow);
  return filter.install() || settings.lenient;
}

}  // namespace fos::grading::inside
