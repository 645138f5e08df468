package org.u2sa.cli.doctor;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.time.Clock;

/** Checks of the machine: Java, memory, disk, ports, clock, serial ports. */
final class MachineChecks {
  private static final int OLDEST_JAVA = 17;
  private static final long MIN_HEAP = 256L << 20;
  private static final long MIN_DISK = 1L << 30;
  private static final double MIB = 1 << 20;
  private static final double GIB = 1 << 30;
  private static final double WAIT_S = 0.02;
  private static final int WAITS = 10;
  private static final double COARSE_MS = 5.0;
  private static final long EARLIEST_MICROS = 1_704_067_200_000_000L; // 2024-01-01

  private final Path devices;

  MachineChecks(Path devices) {
    this.devices = devices;
  }

  Finding java() {
    int feature = Runtime.version().feature();
    String found = System.getProperty("java.version") + ", " + System.getProperty("java.home");
    return feature < OLDEST_JAVA
        ? Finding.failure("Java", found, "install a JDK 17 or newer, or set JAVA_HOME to one")
        : Finding.ok("Java", found);
  }

  Finding memory() {
    long heap = Runtime.getRuntime().maxMemory();
    String found =
        String.format(
            Locale.ROOT,
            "maximum heap %.0f MiB, %d processors",
            heap / MIB,
            Runtime.getRuntime().availableProcessors());
    return heap < MIN_HEAP
        ? Finding.warning("memory", found, "enlarge the heap: U2SA_JAVA_OPTS=-Xmx256m")
        : Finding.ok("memory", found);
  }

  Finding disk(Path folder) {
    Path there = folder.toAbsolutePath();
    try {
      long free = Files.getFileStore(there).getUsableSpace();
      String found = String.format(Locale.ROOT, "%.1f GiB free in %s", free / GIB, there);
      if (!Files.isWritable(there)) {
        return Finding.failure(
            "disk",
            there + " cannot be written to",
            "change to a writable folder: runs write to out/");
      }
      return free < MIN_DISK
          ? Finding.warning("disk", found, "make room: an hour of recording takes up to 120 MB")
          : Finding.ok("disk", found);
    } catch (IOException e) {
      return Finding.failure("disk", there + ": " + e, "change to a readable folder");
    }
  }

  /** Whether a program can listen on a loopback port. */
  Finding port(int port, boolean brokerAnswers) {
    String subject = "port " + port;
    if (brokerAnswers) {
      return Finding.ok(subject, "in use by a running broker");
    }
    try (ServerSocket socket = new ServerSocket()) {
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
      return Finding.ok(subject, "free");
    } catch (IOException e) {
      return Finding.warning(
          subject,
          e.getMessage(),
          "stop the program that uses it (ss -ltnp), or choose another port: --port, COMMUNICATION MANAGER PORT");
    }
  }

  /** Checks the date, and the delay of 20 ms waits as used by control. */
  Finding clock(Clock clock) throws InterruptedException {
    List<Double> lateMs = new ArrayList<>();
    try (Clock.Waiter waiter = clock.newWaiter("doctor")) {
      for (int i = 0; i < WAITS; i++) {
        long due = clock.micros() + Clock.micros(WAIT_S);
        while (clock.micros() < due) {
          waiter.await(due);
        }
        lateMs.add((clock.micros() - due) / 1e3);
      }
    }
    double worst = lateMs.stream().mapToDouble(Double::doubleValue).max().orElseThrow();
    String found = String.format(Locale.ROOT, "waits of 20 ms end up to %.1f ms late", worst);
    if (clock.micros() < EARLIEST_MICROS) {
      return Finding.warning(
          "clock", "the date is before 2024; " + found, "set it: timedatectl, or NTP");
    }
    return worst > COARSE_MS
        ? Finding.warning(
            "clock",
            found,
            "stop other programs, or raise this one's priority, because real-time control suffers")
        : Finding.ok("clock", found);
  }

  /** Checks serial ports, and whether this account may open them. */
  Finding serialPorts() {
    List<Path> ports;
    try (Stream<Path> files = Files.list(devices)) {
      ports =
          files
              .filter(file -> file.getFileName().toString().matches("tty(USB|ACM|AMA|IOIO)\\d+"))
              .sorted()
              .collect(Collectors.toList());
    } catch (IOException e) {
      return Finding.optional(
          "serial ports", "cannot list " + devices, "connect devices by TCP instead");
    }
    if (ports.isEmpty()) {
      return Finding.optional(
          "serial ports",
          "none",
          "connect the board, or pass it through to this machine; demos need none");
    }
    List<Path> closed =
        ports.stream()
            .filter(port -> !Files.isReadable(port) || !Files.isWritable(port))
            .collect(Collectors.toList());
    return closed.isEmpty()
        ? Finding.ok("serial ports", words(ports))
        : Finding.warning(
            "serial ports",
            "no permission to open " + words(closed),
            "sudo usermod -aG dialout \"$USER\", then log in again");
  }

  private static String words(List<Path> files) {
    return files.stream().map(Path::toString).collect(Collectors.joining(", "));
  }
}
