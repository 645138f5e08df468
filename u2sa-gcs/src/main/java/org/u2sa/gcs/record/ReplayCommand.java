package org.u2sa.gcs.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapChannel;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapMessage;
import org.u2sa.recorder.mcap.McapReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * {@code u2sa replay FILE}: publishes a recording's messages again, or executes its services again.
 */
@Command(
    name = "replay",
    description = {
      "Publish the messages of a recording again, at a broker that runs. With --rerun, execute services again instead.",
      "",
      "Messages are published as they were recorded, timestamps included, under the recorded system's ID unless --system names "
          + "another. Services that run under that ID will obey recorded commands.",
      "",
      "With --rerun no broker is needed: each service is made as it was, given what it was given at the recorded times, and what it "
          + "publishes is compared with the recording, to the byte. Exit code 1: something differs. Rerun only recordings that you "
          + "trust: the service classes that they name are executed."
    })
public final class ReplayCommand implements Callable<Integer> {
  private static final String ENCODING = "cbor";
  private static final long NANOS_PER_MICRO = 1_000L;

  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  @Option(
      names = "--rate",
      paramLabel = "X",
      defaultValue = "1",
      description = "How many times as fast as recorded. Default: ${DEFAULT-VALUE}.")
  private double rate;

  @Option(
      names = "--start",
      paramLabel = "S",
      defaultValue = "0",
      description = "Begin so many seconds after the recording's first message. Default: 0.")
  private double startS;

  @Option(
      names = "--channel",
      paramLabel = "NAME",
      split = ",",
      description = "Publish only these channels, for example state,actuation. Default: all.")
  private List<String> wanted = List.of();

  @Option(names = "--loop", description = "Begin anew at the end, until Ctrl-C.")
  private boolean loop;

  @Mixin private RerunOptions rerun;

  private long published;
  private long refused;

  @Override
  public Integer call() throws IOException, InterruptedException {
    check();
    if (rerun.isWanted()) {
      return rerun.run(file);
    }
    try (McapReader reader = McapReader.open(file)) {
      String system = recordedSystem(reader);
      MqttTransport transport = remote.transport(system);
      PrintWriter out = command.commandLine().getOut();
      try (Connection connection =
          transport.connect("u2sa-replay", new PublisherOnly(this::tell))) {
        out.println("Replaying " + file + " as system " + transport.systemId() + ".");
        do {
          play(reader, connection);
        } while (loop);
      }
      out.println(
          published
              + " messages published"
              + (refused == 0 ? "" : ", " + refused + " not taken by the broker"));
      return refused == 0 ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  private void check() {
    if (!Files.isRegularFile(file)) {
      throw wrong(file + ": no such file; expected a recording (MCAP)");
    }
    if (!(rate > 0.0 && rate <= 1e6)) {
      throw wrong("--rate " + rate + ": expected more than 0, at most 1000000");
    }
    if (!(startS >= 0.0)) {
      throw wrong("--start " + startS + ": expected 0 s or more");
    }
  }

  private ParameterException wrong(String what) {
    return new ParameterException(command.commandLine(), what);
  }

  private void tell(String trouble) {
    command.commandLine().getErr().println("u2sa: " + trouble);
  }

  private String recordedSystem(McapReader reader) {
    Set<String> names = new TreeSet<>();
    for (McapChannel channel : reader.channels().values()) {
      if (isMessage(channel)) {
        names.add(topic(channel).channel());
      }
    }
    Set<String> unknown =
        wanted.stream().filter(name -> !names.contains(name)).collect(Collectors.toSet());
    if (!unknown.isEmpty()) {
      throw new BadInputException(
          file + ": has no channel " + unknown + "; expected some of " + names);
    }
    return reader.channels().values().stream()
        .filter(ReplayCommand::isMessage)
        .map(channel -> topic(channel).systemId())
        .findFirst()
        .orElseThrow(
            () ->
                new BadInputException(
                    file
                        + ": holds no message as it was published; expected one recorded with --form u2sa or both"));
  }

  private static boolean isMessage(McapChannel channel) {
    return channel.messageEncoding().equals(ENCODING);
  }

  private Topic topic(McapChannel channel) {
    try {
      return Topic.parse(channel.topic());
    } catch (IllegalArgumentException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  private boolean isWanted(McapChannel channel) {
    return isMessage(channel) && (wanted.isEmpty() || wanted.contains(topic(channel).channel()));
  }

  private void play(McapReader reader, Connection connection)
      throws IOException, InterruptedException {
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    Clock clock = new SystemClock();
    long fromNanos = reader.statistics().startNanos() + Math.round(startS * 1e9);
    long beganMicros = clock.micros();
    McapCursor cursor = reader.messages(fromNanos, this::isWanted);
    try (Clock.Waiter waiter = clock.newWaiter("replay")) {
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        long due =
            beganMicros + Math.round((m.get().logTimeNanos() - fromNanos) / rate / NANOS_PER_MICRO);
        while (clock.micros() < due) {
          waiter.await(due);
        }
        publish(connection, codec, reader.channels().get(m.get().channelId()), m.get());
      }
    }
  }

  private void publish(
      Connection connection, MessageCodec codec, McapChannel channel, McapMessage recorded) {
    Topic topic = topic(channel);
    try {
      U2SAData message = codec.decode(topic.typeChain(), recorded.data());
      message.freeze();
      if (connection.publish(Channels.namedOrNew(topic.channel()), message)) {
        published++;
      } else {
        refused++;
      }
    } catch (MalformedMessageException e) {
      throw new BadInputException(file + ": a message on " + channel.topic() + ": " + e, e);
    }
  }
}
