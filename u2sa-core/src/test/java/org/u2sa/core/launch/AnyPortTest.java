package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.PortTakenException;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.FreePort;

/** Systems that may use any port never fail because of a taken one. */
@Timeout(120)
class AnyPortTest {
  private static final int ROUNDS = 5;
  private static final int AT_ONCE = 3;

  /** Does nothing. */
  public static final class Quiet extends EventDrivenService {
    public Quiet(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Quiet");
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  @TempDir private Path directory;
  private SystemFile file;
  private final List<Integer> told = new ArrayList<>();

  @BeforeEach
  void write() throws IOException {
    file =
        SystemFile.read(
            Files.writeString(
                directory.resolve("system.xml"),
                "<system id=\"test\"><service class=\"" + Quiet.class.getName() + "\"/></system>"));
  }

  private LaunchOptions options(int port) {
    return new LaunchOptions()
        .logDirectory(directory.resolve("logs"))
        .override("CommunicationManager", "COMMUNICATION MANAGER PORT", port);
  }

  private static int port(RunningSystem system) {
    return system.communicationManager().address().orElseThrow().getPort();
  }

  @Test
  void start_portTaken_anotherOneIsUsedAndTold() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
        RunningSystem system =
            RunningSystem.start(file, options(taken.getLocalPort()).anyPortIfTaken(told::add))) {
      assertThat(port(system)).isNotEqualTo(taken.getLocalPort());
      assertThat(told).containsExactly(port(system));
    }
  }

  @Test
  void start_portTakenButWanted_isRefused() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      LaunchOptions options = options(taken.getLocalPort());
      assertThatThrownBy(() -> RunningSystem.start(file, options))
          .isInstanceOf(PortTakenException.class)
          .hasMessageContaining("cannot listen on 127.0.0.1:" + taken.getLocalPort());
    }
  }

  @Test
  void start_severalAtTheSameMoment_eachHasAPortOfItsOwn() throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(AT_ONCE);
    try {
      for (int round = 0; round < ROUNDS; round++) {
        int wanted = FreePort.find();
        CyclicBarrier together = new CyclicBarrier(AT_ONCE);
        Callable<RunningSystem> start =
            () -> {
              together.await();
              return RunningSystem.start(file, options(wanted).anyPortIfTaken(port -> {}));
            };
        List<Future<RunningSystem>> started = new ArrayList<>();
        for (int k = 0; k < AT_ONCE; k++) {
          started.add(threads.submit(start));
        }
        Set<Integer> ports = new TreeSet<>();
        for (Future<RunningSystem> each : started) {
          ports.add(port(each.get()));
        }
        for (Future<RunningSystem> each : started) {
          each.get().close();
        }
        assertThat(ports).hasSize(AT_ONCE);
      }
    } finally {
      threads.shutdownNow();
    }
  }
}
