package org.u2sa.cli.look;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.configuration.VariableWatch;
import org.u2sa.gcs.remote.MessageStream;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.report.message.FieldCondition;
import org.u2sa.report.message.FieldPath;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa echo}: prints the messages of a channel, or the values of a variable. */
@Command(
    name = "echo",
    description = {
      "Print the messages of a channel as they arrive, or a variable as it changes.",
      "",
      "  ./u2sa echo state                              all fields, with units",
      "  ./u2sa echo state --field x,y,psi --rate 2     three fields, twice a second",
      "  ./u2sa echo sensed-state --where 'sensorName ~ gps' --where 'xSigma > 0.5 m'",
      "  ./u2sa echo goals --once --json                the newest message, for programs",
      "  ./u2sa echo 'PathPlanner:LOOK AHEAD'           a variable and its changes",
      "",
      "A field is psi, ranges[3], ranges[-1], point.x, goals[0].uid or objects.size. A condition is FIELD OPERATOR VALUE with one of "
          + "= != < <= > >= ~ (contains, ignoring case); a number may have a unit. All conditions must hold; for an absent field, only != holds.",
      "",
      "Exit code 1: nothing was received within --timeout (with --once or --count) or --for."
    })
public final class EchoCommand extends BaseCommand {
  private static final long LOOK_MS = 100;

  @Mixin private RemoteSystem remote;
  @Mixin private ListeningTime time;

  @Parameters(
      paramLabel = "CHANNEL|SERVICE:VARIABLE",
      completionCandidates = ChannelNames.class,
      description = "What to print.")
  private String what;

  private final List<FieldPath> fields = new ArrayList<>();
  private final List<FieldCondition> conditions = new ArrayList<>();

  @Option(names = "--once", description = "End after one message.")
  private boolean once;

  @Option(
      names = "--count",
      paramLabel = "N",
      description = "End after this many messages. Default: never.")
  private Long count;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      description =
          "Print at most this many messages per second; others are skipped. Default: all.")
  private Double rate;

  @Option(names = "--json", description = "Print JSON, one object per line.")
  private boolean json;

  @Option(
      names = "--field",
      paramLabel = "FIELD",
      split = ",",
      description = "Print these fields only, in one line.")
  private void fields(List<String> texts) {
    for (String text : texts) {
      try {
        fields.add(FieldPath.parse(text));
      } catch (IllegalArgumentException e) {
        throw wrong("--field " + e.getMessage());
      }
    }
  }

  @Option(
      names = "--where",
      paramLabel = "CONDITION",
      description = "Print only messages that meet this condition; may be given several times.")
  private void conditions(List<String> texts) {
    for (String text : texts) {
      try {
        conditions.add(FieldCondition.parse(text));
      } catch (IllegalArgumentException e) {
        throw wrong("--where " + e.getMessage());
      }
    }
  }

  @Override
  public Integer call() throws InterruptedException {
    if (count != null && count < 1) {
      throw wrong("--count " + count + ": expected 1 or more");
    }
    if (rate != null && !(rate > 0.0)) {
      throw wrong("--rate " + rate + ": expected more than 0");
    }
    int colon = what.indexOf(':');
    if (colon > 0) {
      return variable(what.substring(0, colon), what.substring(colon + 1));
    }
    Channel<?> channel = ChannelNames.channel(what);
    try (RemoteLink link = remote.connect()) {
      return print(link, channel);
    }
  }

  private long most() {
    return once ? 1 : count == null ? Long.MAX_VALUE : count;
  }

  private int print(RemoteLink link, Channel<?> channel) throws InterruptedException {
    MessageText text = new MessageText(fields);
    MessageStream stream = new MessageStream(link).of(channel);
    long began = link.clock().micros();
    long apart = rate == null ? 0 : Clock.micros(1.0 / rate);
    long printed = 0;
    long due = Long.MIN_VALUE;
    while (printed < most() && !isOver(link, began, printed)) {
      Optional<MessageStream.Heard> heard = stream.next(LOOK_MS);
      if (heard.isEmpty() || heard.get().micros() < due || !isWanted(heard.get())) {
        continue;
      }
      due = heard.get().micros() + apart;
      printed++;
      if (json) {
        print(text.json(heard.get()));
      } else {
        text.lines(heard.get()).forEach(out()::println);
      }
      if (out().checkError()) {
        return ExitCode.DONE; // the reader has exited, e.g. head
      }
    }
    if (stream.dropped() > 0) {
      tell(stream.dropped() + " messages came faster than they were printed");
    }
    if (printed == 0) {
      double seconds = (link.clock().micros() - began) / 1e6;
      throw new RunFailedException(
          ChannelNames.nothingHeard(channel, link.systemId(), seconds)
              + (conditions.isEmpty() ? "" : " that meets the conditions"));
    }
    return ExitCode.DONE;
  }

  /**
   * Whether to stop. With a message count, the wait for the first message is limited to the answer
   * timeout.
   */
  private boolean isOver(RemoteLink link, long beganMicros, long printed) {
    long now = link.clock().micros();
    boolean waitedEnough =
        most() < Long.MAX_VALUE
            && !time.isBounded()
            && printed == 0
            && now - beganMicros >= Clock.micros(link.timeoutS());
    return time.isOver(beganMicros, now) || waitedEnough;
  }

  private boolean isWanted(MessageStream.Heard heard) {
    for (FieldCondition condition : conditions) {
      try {
        if (!condition.holds(heard.message())) {
          return false;
        }
      } catch (IllegalArgumentException e) {
        throw new BadInputException("--where: " + e.getMessage(), e);
      }
    }
    return true;
  }

  private int variable(String service, String name) throws InterruptedException {
    if (!fields.isEmpty() || !conditions.isEmpty()) {
      throw wrong("--field and --where: expected a channel, not the variable \"" + what + "\"");
    }
    try (RemoteLink link = remote.connect();
        VariableWatch watch = VariableWatch.of(link, service, name)) {
      long began = link.clock().micros();
      long printed = 0;
      while (printed < most() && !time.isOver(began, link.clock().micros())) {
        Optional<VariableWatch.Value> next = watch.next(LOOK_MS);
        if (next.isPresent()) {
          print(service, name, next.get());
          printed++;
        }
      }
      return ExitCode.DONE;
    }
  }

  private void print(String service, String name, VariableWatch.Value value) {
    if (json) {
      print(
          new JsonText()
              .put("service", service)
              .put("variable", name)
              .put("receivedMicros", value.micros())
              .put("value", value.text())
              .put("unit", value.unit())
              .put("author", value.author())
              .line());
      return;
    }
    String unit = value.unit().isEmpty() ? "" : " " + value.unit();
    String by = value.author().isEmpty() ? "" : "  set by " + value.author();
    print(
        MessageText.time(value.micros())
            + "  "
            + service
            + ":"
            + name
            + " = "
            + value.text()
            + unit
            + by);
  }
}
