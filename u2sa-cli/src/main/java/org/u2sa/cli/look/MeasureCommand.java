package org.u2sa.cli.look;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongFunction;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * {@code u2sa hz}, {@code delay} and {@code bw}: measures the messages of channels, one row per
 * source.
 */
public abstract sealed class MeasureCommand extends BaseCommand {
  private static final double EVERY_S = 1.0;

  /** Measures message rates. */
  @Command(
      name = "hz",
      description = {
        "Measure the message rate of each source of a channel.",
        "",
        "  ./u2sa hz                           all standard channels, until Ctrl-C",
        "  ./u2sa hz state actuation --for 5 --json",
        "",
        "Exit code 1: nothing was received. DEVIATION is the standard deviation of the intervals, up to the newest 10,000. LAST: time since the last message; RATE is 0 after 2 s without one, or after 5 mean intervals if longer."
      })
  public static final class Rate extends MeasureCommand {
    public Rate() {
      super(Meter.Rate.COLUMNS, began -> new Meter.Rate());
    }
  }

  /** Measures the age of messages on arrival. */
  @Command(
      name = "delay",
      description = {
        "Measure the latency from a message's timestamp to its arrival here.",
        "",
        "  ./u2sa delay state",
        "  ./u2sa delay sensed-state state navigation actuation --for 10",
        "",
        "A timestamp is the time of measurement, so the delay includes processing by the service. The clocks of both hosts must "
            + "agree. Messages of a run in simulated time have no such delay; the table shows this. LAST: time since the last message. Exit code 1: nothing was received."
      })
  public static final class Delay extends MeasureCommand {
    public Delay() {
      super(Meter.Delay.COLUMNS, began -> new Meter.Delay());
    }
  }

  /** Measures bandwidth. */
  @Command(
      name = "bw",
      description = {
        "Measure the bandwidth of each source of a channel.",
        "",
        "  ./u2sa bw                           all standard channels, until Ctrl-C",
        "  ./u2sa bw scans grid --for 5",
        "",
        "Bytes are those of the encoded messages, without topics and MQTT overhead. BANDWIDTH is the mean since the command began; "
            + "LAST: time since the last message. Exit code 1: nothing was received."
      })
  public static final class Bandwidth extends MeasureCommand {
    public Bandwidth() {
      super(Meter.Bandwidth.COLUMNS, Meter.Bandwidth::new);
    }
  }

  private final MeasuredSources sources; // guarded by itself

  @Mixin private RemoteSystem remote;
  @Mixin private ListeningTime time;

  @Parameters(
      arity = "0..*",
      paramLabel = "CHANNEL",
      completionCandidates = ChannelNames.class,
      description = "The channels. Default: all standard ones.")
  private List<String> names = List.of();

  @Option(
      names = "--json",
      description = "Print JSON: one object per second, or a single one at the end with --for.")
  private boolean json;

  private MeasureCommand(List<String> columns, LongFunction<Meter> meterFrom) {
    sources = new MeasuredSources(columns, meterFrom);
  }

  @Override
  public Integer call() throws InterruptedException {
    List<Channel<?>> channels = new ArrayList<>();
    names.forEach(name -> channels.add(ChannelNames.channel(name)));
    try (RemoteLink link = remote.connect()) {
      long began = link.clock().micros();
      for (Channel<?> channel : channels.isEmpty() ? Channels.all() : channels) {
        link.listen(channel, message -> take(channel, message, link.clock().micros(), began));
      }
      show(link, began);
      synchronized (sources) {
        if (sources.isEmpty()) {
          throw new RunFailedException(
              "nothing received from system \""
                  + link.systemId()
                  + "\" on "
                  + (names.isEmpty() ? "any channel" : String.join(", ", names)));
        }
      }
      return ExitCode.DONE;
    }
  }

  private void take(Channel<?> channel, U2SAData message, long micros, long beganMicros) {
    synchronized (sources) {
      sources.take(channel, message, micros, beganMicros);
    }
  }

  private void show(RemoteLink link, long began) throws InterruptedException {
    Terminal terminal = terminal();
    long due = began;
    try (Clock.Waiter waiter = link.clock().newWaiter("measure")) {
      while (!time.isOver(began, link.clock().micros()) && !terminal.out().checkError()) {
        due += Clock.micros(EVERY_S);
        waitUntil(link, waiter, began, due);
        if (!time.isBounded()) {
          print(terminal, link.clock().micros());
        }
      }
    }
    if (time.isBounded()) {
      print(terminal, link.clock().micros());
    }
  }

  private void waitUntil(RemoteLink link, Clock.Waiter waiter, long began, long due)
      throws InterruptedException {
    long step = Clock.micros(EVERY_S) / 10;
    long now = link.clock().micros();
    while (now < due && !time.isOver(began, now)) {
      waiter.await(Math.min(due, now + step));
      now = link.clock().micros();
    }
  }

  private void print(Terminal terminal, long now) {
    PrintWriter out = terminal.out();
    synchronized (sources) {
      if (json) {
        out.println(sources.json(now));
        return;
      }
      if (terminal.redraws() && !time.isBounded()) {
        terminal.clear();
      }
      sources.table(now).lines().forEach(out::println);
      out.flush();
    }
  }
}
