package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Services obey on a disk that hangs: the thread of all files waits for a pipe, or one of the
 * service's own files is one.
 */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class DiskHangTest {
  @TempDir private Path folder;
  private final LocalBus bus = new LocalBus("test");
  private final BlockingQueue<String> moves = new LinkedBlockingQueue<>();
  private Wheel wheel;

  private final class Wheel extends Actuator {
    Wheel(ServiceContext context) {
      super(context, "WHEEL");
    }

    @Override
    protected void actuate(double percentage) {
      remember();
      log("moves");
      moves.add(String.valueOf(percentage));
    }

    @Override
    protected void neutral() {
      moves.add("neutral");
    }

    @Override
    protected ActuatorAnnouncement announcement() {
      return super.announcement().minimum(0.0);
    }

    @Override
    protected void handOver(HandOver state) {
      state.text("MOVED", "yes");
    }
  }

  private void makePipe(String name) throws IOException, InterruptedException {
    assertThat(new ProcessBuilder("mkfifo", folder.resolve(name).toString()).start().waitFor())
        .isZero();
  }

  @BeforeEach
  void hang() throws IOException, InterruptedException {
    makePipe("disk");
    Path disk = folder.resolve("disk");
    DiskThread.ofProcess()
        .execute(
            () -> {
              try {
                Files.newOutputStream(disk).close(); // waits for a reader
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });
  }

  private void start(double expiryS) {
    wheel =
        new Wheel(
            ServiceContext.of(
                    "test", XmlConfiguration.inMemory("test", Map.of("COMMAND EXPIRY", expiryS)))
                .clock(new SystemClock())
                .transport(bus)
                .logDirectory(folder)
                .build());
    wheel.start();
  }

  private void letTheDiskAnswer() throws IOException {
    if (Files.deleteIfExists(folder.resolve("answered"))) {
      return;
    }
    Files.newInputStream(folder.resolve("disk")).close();
    Files.createFile(folder.resolve("answered"));
  }

  @AfterEach
  void end() throws IOException {
    letTheDiskAnswer();
    wheel.kill();
  }

  private void deliver(U2SAData message) {
    message.systemId("test");
    message.timestamp(new SystemClock().micros());
    message.freeze();
    if (message instanceof EmergencyStop stop) {
      bus.deliver(Channels.EMERGENCY_STOP, stop);
    } else {
      bus.deliver(Channels.ACTUATION, message);
    }
  }

  private void awaitMove(String expected) throws InterruptedException {
    String move;
    do {
      move = moves.poll(60, TimeUnit.SECONDS);
    } while (move != null && !move.equals(expected));
    assertThat(move).isEqualTo(expected);
  }

  @Test
  void command_afterALogLineAndASavedState_expires() throws InterruptedException {
    start(2.0); // longer than a busy machine keeps the command waiting
    deliver(PercentageCommand.of("WHEEL", 40.0));
    awaitMove("40.0");

    awaitMove("neutral");
  }

  @Test
  void log_filesAreNamedPipes_doNotBlockOtherFiles() throws Exception {
    makePipe("WHEEL.log");
    makePipe("WHEEL.progress.tmp");
    start(60.0);
    deliver(PercentageCommand.of("WHEEL", 40.0)); // writes both
    awaitMove("40.0");
    letTheDiskAnswer();

    assertThat(DiskThread.ofProcess().call(() -> "done", 30_000)).isEqualTo("done");
  }

  @Test
  void stop_afterARefusalThatIsLogged_isObeyed() throws InterruptedException {
    start(60.0);
    deliver(PercentageCommand.of("WHEEL", -1.0)); // refused, with a line of the log
    deliver(PercentageCommand.of("WHEEL", 50.0));
    awaitMove("50.0");

    deliver(new EmergencyStop().active(true).operator("ann").reason("smoke").stopId("s"));
    awaitMove("neutral");
  }
}
