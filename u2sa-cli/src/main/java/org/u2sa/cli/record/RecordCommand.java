package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicBoolean;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.ServiceContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa record}: records a remote system. */
@Command(
    name = "record",
    description = {
      "Record all messages of a running system until Ctrl-C.",
      "",
      "Joins the system by MQTT as a service named Recorder. Messages are written to the file four times a second, so a crash loses at most a quarter of a second. ./u2sa recover repairs a truncated file."
    })
public final class RecordCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;
  @Mixin private RecordOptions options;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      defaultValue = "recording.mcap",
      description =
          "Output file; a number is appended to the name if it exists. Default: ${DEFAULT-VALUE}.")
  private Path out;

  @Mixin private ListeningTime time;

  private final AtomicBoolean ended = new AtomicBoolean();

  @Override
  public Integer call() throws InterruptedException, IOException {
    Path folder = out.toAbsolutePath().getParent();
    MqttTransport transport = remote.transport();
    Files.createDirectories(folder);
    ServiceContext context =
        ServiceContext.of(transport.systemId(), options.configuration(out.getFileName().toString()))
            .transport(transport)
            .logDirectory(folder)
            .build();
    Recorder recorder = new Recorder(context, new RunFacts().facts());
    recorder.start();
    Thread end = new Thread(() -> end(recorder), "u2sa-record-end");
    Runtime.getRuntime().addShutdownHook(end);
    print("Recording system " + transport.systemId() + ". Ctrl-C ends it.");
    out().flush();
    await(recorder);
    end(recorder);
    return ExitCode.DONE;
  }

  private void await(Recorder recorder) throws InterruptedException {
    if (!time.isBounded()) {
      recorder.join();
      return;
    }
    Clock clock = new SystemClock();
    try (Clock.Waiter waiter = clock.newWaiter("record")) {
      long until = time.end(clock.micros());
      while (recorder.isRunning() && clock.micros() < until) {
        waiter.await(Math.min(until, clock.micros() + Clock.MICROS_PER_SECOND));
      }
    }
  }

  /**
   * Called when the time has elapsed and when the program is interrupted; only the first call has
   * an effect.
   */
  private void end(Recorder recorder) {
    recorder.finish();
    if (ended.getAndSet(true)) {
      return;
    }
    print(
        recorder.messages()
            + " messages recorded into "
            + recorder.files()
            + (recorder.dropped() == 0
                ? ""
                : ", not counting " + recorder.dropped() + " that arrived too fast"));
    out().flush();
  }
}
