package org.u2sa.trials.board;

import java.io.File;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.sim.device.SerialInstrument;

/**
 * A vehicle's serial devices as pseudo terminals in a folder, created by socat because Java cannot
 * create them. A program that opens one is connected to the device through a Unix socket that only
 * this account can open; data that it does not read in time are lost, as on a serial port. The baud
 * rate does not matter. Uses one thread.
 */
final class SerialPorts implements AutoCloseable {
  private static final long PAUSE_MS = 5;
  private static final long AGAIN_AFTER_MICROS = 500_000;
  private static final int BUFFER = 1024;
  private static final long END_WITHIN_S = 5;

  private final LongSupplier nowMicros;
  private final Consumer<String> log;
  private final Path sockets;
  private final List<Line> lines = new ArrayList<>();
  private final Thread thread = new Thread(this::work, "u2sa-board-serial");
  private volatile boolean closed;

  /** One device, its port and the program that has opened it. */
  private final class Line {
    private final SerialInstrument device;
    private final Path link;
    private final ServerSocketChannel server;
    private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
    private final byte[] bytes = new byte[BUFFER];
    private Process socat;
    private SocketChannel opened; // null while the port is not open
    private long retryMicros;
    private long beforeMicros;

    Line(String name, SerialInstrument device, Path folder) throws IOException {
      this.device = device;
      link = folder.resolve(name);
      server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
      server.bind(UnixDomainSocketAddress.of(sockets.resolve(name)));
      server.configureBlocking(false);
    }

    private void start() throws IOException {
      socat =
          new ProcessBuilder(
                  "socat",
                  "pty,raw,echo=0,wait-slave,mode=600,link=" + link,
                  "unix-connect:" + ((UnixDomainSocketAddress) server.getLocalAddress()).getPath())
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.to(new File("/dev/null")))
              .start();
    }

    void pass(long micros) throws IOException {
      device.advance(micros, beforeMicros);
      beforeMicros = micros;
      if ((socat == null || !socat.isAlive()) && micros >= retryMicros) {
        retryMicros = micros + AGAIN_AFTER_MICROS; // socat ends when the port is closed
        start();
      }
      SocketChannel next = server.accept();
      if (next != null) {
        leave();
        next.configureBlocking(false);
        opened = next;
      }
      if (opened != null) {
        try {
          exchange(micros);
        } catch (IOException e) {
          leave();
        }
      }
    }

    private void exchange(long micros) throws IOException {
      int count = device.take(micros, device.baud(), bytes);
      opened.write(ByteBuffer.wrap(bytes, 0, count));
      buffer.clear();
      int read = opened.read(buffer);
      if (read < 0) {
        leave();
      } else if (read > 0) {
        device.accept(micros, device.baud(), buffer.array(), read);
      }
    }

    private void leave() throws IOException {
      if (opened != null) {
        opened.close();
        opened = null;
      }
    }

    void end() throws IOException, InterruptedException {
      leave();
      server.close();
      if (socat != null) {
        socat.destroy();
        if (!socat.waitFor(END_WITHIN_S, TimeUnit.SECONDS)) {
          socat.destroyForcibly();
        }
      }
      Files.deleteIfExists(sockets.resolve(link.getFileName()));
      Files.deleteIfExists(link);
    }
  }

  /**
   * @param folder for the ports, each named after its device
   * @param nowMicros time since the start [µs]
   * @throws BadInputException if there is no socat, or a file is in the way
   */
  SerialPorts(
      Map<String, SerialInstrument> devices,
      Path folder,
      LongSupplier nowMicros,
      Consumer<String> log)
      throws IOException {
    this.nowMicros = nowMicros;
    this.log = log;
    requireSocat();
    Files.createDirectories(folder);
    sockets =
        Files.createTempDirectory(
            "u2sa-board",
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    for (Map.Entry<String, SerialInstrument> each : new TreeMap<>(devices).entrySet()) {
      String name = each.getKey().replaceAll("[^A-Za-z0-9_-]", "_");
      Path link = folder.resolve(name);
      if (Files.isSymbolicLink(link)) {
        Files.delete(link); // left by a program that was killed
      } else if (Files.exists(link)) {
        throw new BadInputException(
            "--serial: " + link + " already exists; expected a folder without it");
      }
      lines.add(new Line(name, each.getValue(), folder));
    }
    thread.setDaemon(true);
    thread.start();
  }

  private static void requireSocat() throws IOException {
    try {
      Process version = new ProcessBuilder("socat", "-V").redirectErrorStream(true).start();
      version.getInputStream().readAllBytes();
    } catch (IOException e) {
      throw new BadInputException(
          "--serial: serial ports need socat, which was not found (Debian: apt install socat)", e);
    }
  }

  List<Path> ports() {
    return lines.stream().map(line -> line.link).toList();
  }

  private void work() {
    try {
      while (!closed) {
        for (Line line : lines) {
          line.pass(nowMicros.getAsLong());
        }
        synchronized (this) {
          wait(PAUSE_MS);
        }
      }
    } catch (IOException | RuntimeException e) {
      log.accept("the serial ports have failed: " + e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void close() throws IOException {
    closed = true;
    try {
      thread.join();
      for (Line line : lines) {
        line.end();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    Files.deleteIfExists(sockets);
  }
}
