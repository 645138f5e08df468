package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.playback.Playback;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.recorder.playback.RetainedHistory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa replay FILE}: republishes a recording's messages, or re-executes its services. */
@Command(
    name = "replay",
    description = {
      "Publish the messages of a recording again, to a running broker. With --rerun, execute services again instead.",
      "",
      "Messages are published as they were recorded, timestamps included, under the recorded system's ID unless --system names "
          + "another. Services running under that ID will obey the recorded commands.",
      "",
      "  ./u2sa replay recording.mcap --from 60 --to 90 --rate 2 --channel state,navigation",
      "",
      "At a terminal: space pauses, s plays the next message and pauses, left and right go 5 s back and forward, up and down "
          + "double and halve the rate, q ends.",
      "",
      "With --web no broker is needed: a browser shows the recording in the operator's page, with a timeline.",
      "",
      "With --rerun no broker is needed: each service is recreated and given its recorded input at the recorded times, and its output is compared with the recording, byte by byte. Exit code 1: something differs. Rerun only recordings that you "
          + "trust: the service classes that they name are executed."
    })
public final class ReplayCommand extends BaseCommand {
  private static final int HIGHEST_PORT = 65_535;

  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  @Option(
      names = "--rate",
      paramLabel = "X",
      defaultValue = "1",
      description = "Speed relative to the recording. Default: ${DEFAULT-VALUE}.")
  private double rate;

  @Mixin private SpanOptions part;

  @Option(
      names = "--channel",
      paramLabel = "NAME",
      split = ",",
      description = "Publish only these channels, for example state,actuation. Default: all.")
  private List<String> wanted = List.of();

  @Option(names = "--loop", description = "Restart at the end, until Ctrl-C.")
  private boolean loop;

  @Option(
      names = "--web",
      paramLabel = "PORT",
      description =
          "Show the recording in the operator's page on this port of this host; its broker uses"
              + " the next port. Paused at the end, until Ctrl-C.")
  private Integer web; // null: publish to a running broker

  @Mixin private RerunOptions rerun;

  private long published;
  private long refused;

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (!(rate > 0.0 && rate <= 1e6)) {
      throw wrong("--rate " + rate + ": expected more than 0, at most 1000000");
    }
    if (rerun.isWanted()) {
      refuseParts();
      return rerun.run(file);
    }
    try (RecordedMessages recording = RecordedMessages.open(file).requireMessages()) {
      RecordingParts.othersNotRead(file).ifPresent(this::tell);
      RecordedSpan span = part.of(recording.reader());
      Predicate<McapChannel> channels = recording.channels(wanted);
      Playback playback =
          new Playback(recording.reader(), channels, span, rate, loop, new SystemClock());
      if (web != null) {
        return playOnPage(recording, playback, span);
      }
      MqttTransport transport = remote.transport(recording.systemId().orElseThrow());
      try (Connection connection = transport.connect("u2sa-replay", new PublisherOnly(this::tell));
          PlaybackKeys keys = PlaybackKeys.of(terminal(), playback)) {
        print("Replaying " + file + " as system " + transport.systemId() + ".");
        keys.explain();
        playback.play(
            new Playback.Sink() {
              @Override
              public void play(McapMessage message) {
                publish(connection, recording, message);
              }

              @Override
              public void at(Playback.Position position) {
                keys.show(position, span, recording.reader().statistics());
              }
            },
            () -> false);
      }
      recording.undecodable().ifPresent(this::tell);
      print(
          published
              + " messages published"
              + (refused == 0 ? "" : ", " + refused + " not accepted by the broker"));
      return refused == 0 ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  private int playOnPage(RecordedMessages recording, Playback playback, RecordedSpan span)
      throws IOException, InterruptedException {
    if (web < 1 || web >= HIGHEST_PORT) {
      throw wrong("--web " + web + ": expected 1…" + (HIGHEST_PORT - 1));
    }
    McapStatistics statistics = recording.reader().statistics();
    RetainedHistory history = new RetainedHistory(recording);
    try (WebPlayback page =
            new WebPlayback(
                web, recording.systemId().orElseThrow(), playback, statistics, this::print);
        PlaybackKeys keys = PlaybackKeys.of(terminal(), playback)) {
      keys.explain();
      playback.play(
          new Playback.Sink() {
            @Override
            public void play(McapMessage message) {
              publish(page.connection(), recording, message);
            }

            @Override
            public void at(Playback.Position position) {
              keys.show(position, span, statistics);
              page.show(position);
            }

            @Override
            public void sought(long nanos) throws IOException {
              history.before(nanos).forEach(this::play);
            }
          },
          () -> false);
    }
    recording.undecodable().ifPresent(this::tell);
    return ExitCode.DONE;
  }

  /** Rejects a part: services are re-executed from their start with all their inputs. */
  private void refuseParts() {
    for (String option : List.of("--from", "--to", "--channel", "--rate", "--loop", "--web")) {
      if (commandLine().getParseResult().hasMatchedOption(option)) {
        throw wrong(option + ": cannot be used with --rerun, which executes the whole recording");
      }
    }
  }

  private void publish(Connection connection, RecordedMessages recording, McapMessage recorded) {
    Topic topic =
        recording.topic(recording.reader().channels().get(recorded.channelId())).orElseThrow();
    recording
        .decode(topic, recorded)
        .ifPresent(
            message -> {
              message.freeze();
              if (connection.publish(Channels.namedOrNew(topic.channel()), message)) {
                published++;
              } else {
                refused++;
              }
            });
  }
}
