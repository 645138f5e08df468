package org.u2sa.cli.look;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.JsonReader;
import org.u2sa.report.message.MessageFromJson;
import org.u2sa.report.message.MessageJson;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa publish}: publishes a user-defined message on a channel. */
@Command(
    name = "publish",
    description = {
      "Publish a message, checked by the schema of its type.",
      "",
      "  ./u2sa publish power '{\"sensorName\": \"bench\", \"voltage\": 11.1}'",
      "  ./u2sa publish goal-updates '{\"type\": \"Waypoint\", \"uid\": \"9\", \"referenceFrame\": \"GLOBAL\", \"x\": 8.0, \"y\": 50.0}'",
      "  ./u2sa publish state @state.json --rate 10 --count 50",
      "  ./u2sa echo state --once --json | jq .fields | ./u2sa publish state - --system copy",
      "",
      "A number is in the unit of its field; a text may give another: \"90 deg\". systemId and "
          + "timestamp are filled in where absent. The broker's access rules apply "
          + "(docs/security.md): the command checks and reports whether the message was delivered.",
      "",
      "Exit code 0: delivered; 1: not delivered, or delivery could not be checked; 2: the "
          + "message is invalid, and nothing was published."
    })
public final class PublishCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;

  @Parameters(
      index = "0",
      paramLabel = "CHANNEL",
      completionCandidates = ChannelNames.class,
      description = "The channel.")
  private String channelName;

  @Parameters(
      index = "1",
      paramLabel = "JSON|@FILE|-",
      description =
          "The fields as a JSON object; @FILE to read it from a file; or - for "
              + "standard input.")
  private String text;

  @Option(
      names = "--type",
      paramLabel = "TYPE",
      description = "The message's type. Default: \"type\" in the JSON, or the channel's own.")
  private String typeName;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      defaultValue = "1",
      description = "With --count: messages per second. Default: ${DEFAULT-VALUE}.")
  private double rate;

  @Option(
      names = "--count",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Number of messages to publish, each with its own timestamp. Default: ${DEFAULT-VALUE}.")
  private long count;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  private enum Outcome {
    CAME_THROUGH,
    NOT_HEARD,
    NOT_ALLOWED_TO_HEAR
  }

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (count < 1) {
      throw wrong("--count " + count + ": expected 1 or more");
    }
    if (!(rate > 0.0 && rate <= 10_000.0)) {
      throw wrong("--rate " + rate + ": expected more than 0, at most 10000");
    }
    Channel<?> channel = ChannelNames.channel(channelName);
    U2SAData message = message(channel);
    try (RemoteLink link = remote.connectForOrders()) {
      U2SAData last = message;
      Outcome outcome = Outcome.NOT_HEARD;
      long began = link.clock().micros();
      for (long i = 0; i < count; i++) {
        waitUntil(link, began + Math.round(i / rate * 1e6));
        last = message.copy();
        outcome =
            i == count - 1 ? publishAndListen(link, channel, last) : publish(link, channel, last);
      }
      print(link, channel, last, outcome);
      if (outcome != Outcome.CAME_THROUGH) {
        remote.explainRefusal();
      }
      return outcome == Outcome.CAME_THROUGH ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  private U2SAData message(Channel<?> channel) throws IOException {
    String origin = text.startsWith("@") ? text.substring(1) : text.equals("-") ? "input" : "JSON";
    Map<String, Object> fields = JsonReader.object(origin, source());
    MessageFromJson reader = new MessageFromJson(MessageTypes.discovered());
    if (typeName != null) {
      fields.put("type", typeName);
    }
    List<MessageType<?>> carried = channel.carriedTypes();
    Optional<MessageType<?>> own =
        carried.size() == 1 && !carried.get(0).isAbstract()
            ? Optional.of(carried.get(0))
            : Optional.empty();
    MessageType<?> type = named(reader, origin, fields, own, carried);
    if (!channel.carries(type)) {
      throw new BadInputException(
          String.format(
              "%1$s: \"%3$s\" does not carry a %2$s; it carries %4$s",
              origin, type.name(), channel, names(carried)));
    }
    return reader.message(origin, type, fields);
  }

  private static MessageType<?> named(
      MessageFromJson reader,
      String origin,
      Map<String, Object> fields,
      Optional<MessageType<?>> own,
      List<MessageType<?>> carried) {
    if (own.isEmpty() && !fields.containsKey("type")) {
      throw new BadInputException(
          origin
              + ": expected \"type\", or --type, with one of "
              + names(carried)
              + " or a subclass");
    }
    return reader.named(origin, fields, own);
  }

  private static String names(List<MessageType<?>> types) {
    return types.stream().map(MessageType::name).collect(Collectors.joining(", "));
  }

  private String source() throws IOException {
    if (text.equals("-")) {
      InputStream in = System.in;
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
    if (!text.startsWith("@")) {
      return text;
    }
    Path file = Path.of(text.substring(1));
    RegularFile.require(file, "a file with a JSON object");
    return Files.readString(file);
  }

  private static void waitUntil(RemoteLink link, long micros) throws InterruptedException {
    try (Clock.Waiter waiter = link.clock().newWaiter("publish")) {
      while (link.clock().micros() < micros) {
        waiter.await(micros);
      }
    }
  }

  private static Outcome publish(RemoteLink link, Channel<?> channel, U2SAData message) {
    link.publish(channel, message);
    return Outcome.NOT_HEARD;
  }

  /**
   * Subscribes to its own message, because a broker silently drops messages that are not permitted.
   */
  private static Outcome publishAndListen(RemoteLink link, Channel<?> channel, U2SAData message)
      throws InterruptedException {
    AtomicReference<U2SAData> sent = new AtomicReference<>();
    AtomicReference<Boolean> heard = new AtomicReference<>(false);
    boolean listens = true;
    try {
      link.listen(
          channel,
          each -> {
            if (each.equals(sent.get())) {
              heard.set(true);
            }
          });
    } catch (CommunicationException e) { // publishing may still be permitted
      listens = false;
    }
    fillIn(link, message);
    sent.set(message);
    link.publish(channel, message);
    if (!listens) {
      return Outcome.NOT_ALLOWED_TO_HEAR;
    }
    link.await(heard::get, link.timeoutS());
    return heard.get() ? Outcome.CAME_THROUGH : Outcome.NOT_HEARD;
  }

  private static void fillIn(RemoteLink link, U2SAData message) {
    if (message.systemId().isEmpty()) {
      message.systemId(link.systemId());
    }
    if (message.timestamp().isEmpty()) {
      message.timestamp(link.clock().micros());
    }
    message.freeze();
  }

  private void print(RemoteLink link, Channel<?> channel, U2SAData message, Outcome outcome) {
    if (json) {
      print(
          new JsonText()
              .put("system", link.systemId())
              .put("channel", channel.name())
              .put("type", MessageJson.typeName(message))
              .put("published", count)
              .put("outcome", outcome.name())
              .put("fields", MessageJson.fields(message))
              .line());
      return;
    }
    if (outcome == Outcome.CAME_THROUGH) {
      print((count == 1 ? "" : count + " × ") + "published on " + channel + ": " + message);
      return;
    }
    boolean standard = Channels.named(channel.name()).isPresent();
    throw new RunFailedException(
        outcome == Outcome.NOT_HEARD
            ? String.format(
                "the broker accepted a %s for \"%s\" but did not deliver it within %s s: may the user not publish it%s?"
                    + " (docs/security.md)",
                MessageJson.typeName(message),
                channel,
                link.timeoutS(),
                standard ? "" : " or not receive the channel")
            : "published on \""
                + channel
                + "\"; whether it was delivered is unknown: the user may not receive that channel");
  }
}
