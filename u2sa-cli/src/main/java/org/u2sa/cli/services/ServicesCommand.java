package org.u2sa.cli.services;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.ToLongFunction;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.gcs.services.ServiceRow;
import org.u2sa.gcs.services.ServicesJson;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;
import org.u2sa.service.directory.ServiceDirectory;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa services}: lists services, their health and their data. */
@Command(
    name = "services",
    description = {
      "List the services of a running system, or find them by their data.",
      "",
      "Exit code 1: no service answered, or none has the requested data."
    })
public final class ServicesCommand extends BaseCommand {
  private static final double WATCH_EVERY_S = 1.0;

  @Mixin private RemoteSystem remote;
  @ArgGroup private View view = new View();

  private static final class View {
    @Option(
        names = "--publishing",
        paramLabel = "TYPE",
        description =
            "List publishers of this type, for example StateInformation, and of its subclasses.")
    private String publishing;

    @Option(
        names = "--subscribing",
        paramLabel = "TYPE",
        description = "List services that receive messages of this type.")
    private String subscribing;

    @Option(names = "--json", description = "Print JSON.")
    private boolean json;

    @Option(names = "--watch", description = "Refresh the table every second until Ctrl-C.")
    private boolean watch;
  }

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      DirectoryObservation observation = DirectoryObservation.made(link);
      if (view.publishing != null) {
        List<String> chain = DataType.chain(view.publishing, observation.directory());
        return print(observation.directory().publishersOf(chain), "publishes " + view.publishing);
      }
      if (view.subscribing != null) {
        List<String> chain = DataType.chain(view.subscribing, observation.directory());
        return print(
            observation.directory().subscribersOf(chain), "subscribes to " + view.subscribing);
      }
      if (view.json) {
        printBlock(ServicesJson.text(link.systemId(), observation));
      } else if (view.watch) {
        watch(link, observation);
      } else {
        print("System " + link.systemId() + " at " + remote.brokerAddress());
        ServiceTable.lines(observation.rows()).forEach(out()::println);
      }
      return observation.names().isEmpty() ? ExitCode.FAILED : ExitCode.DONE;
    }
  }

  private int print(List<ServiceDirectory.Found> found, String does) {
    if (found.isEmpty()) {
      print("No service " + does + ".");
      return ExitCode.FAILED;
    }
    TextTable table = new TextTable("NAME", "CHANNEL", "TYPE", "");
    for (ServiceDirectory.Found each : found) {
      table.add(
          each.service().name(),
          each.offer().channel(),
          each.offer().typeName(),
          each.certain() ? "" : "among others of this type");
    }
    table.lines().forEach(out()::println);
    return ExitCode.DONE;
  }

  private void watch(RemoteLink link, DirectoryObservation observation)
      throws InterruptedException {
    Terminal terminal = terminal();
    try (Clock.Waiter waiter = link.clock().newWaiter("watch")) {
      while (!Thread.currentThread().isInterrupted()) {
        observation.directory().ask(); // updates the uptimes
        waiter.await(link.clock().micros() + Clock.micros(WATCH_EVERY_S));
        observation.directory().refresh();
        if (terminal.redraws()) {
          terminal.clear();
        }
        terminal.out().println("System " + link.systemId() + " at " + remote.brokerAddress());
        for (String line : ServiceTable.lines(observation.rows())) {
          terminal.out().println(terminal.redraws() ? terminal.fitted(line) : line);
        }
      }
    }
  }

  private static final class DataType {
    private DataType() {}

    /**
     * Type chain, topmost first, of a type known here or mentioned by a service.
     *
     * @throws BadInputException if the type is unknown; names similar ones
     */
    static List<String> chain(String name, ServiceDirectory directory) {
      Optional<MessageType<?>> known = MessageTypes.discovered().byName(name);
      if (known.isPresent()) {
        return known.get().chain();
      }
      SortedSet<String> names = new TreeSet<>();
      for (MessageType<?> type : MessageTypes.discovered().all()) {
        names.add(type.name());
      }
      for (KnownService service : directory.services()) {
        for (List<DataOffer> offers : List.of(service.publishes(), service.subscribes())) {
          for (DataOffer offer : offers) {
            int at = offer.typeChain().indexOf(name);
            if (at >= 0) {
              return offer.typeChain().subList(0, at + 1);
            }
            names.addAll(offer.typeChain());
          }
        }
      }
      throw new BadInputException(
          String.format(
              "data type \"%s\" is unknown here and to all services%s",
              name, NearestNames.didYouMean(name, names)));
    }
  }

  private static final class ServiceTable {
    private static final double SECONDS_PER_MINUTE = 60.0;
    private static final double MICROS_PER_SECOND = 1e6;
    private static final double MILLIS_PER_SECOND = 1e3;

    private ServiceTable() {}

    static List<String> lines(List<ServiceRow> rows) {
      TextTable table =
          new TextTable(
              "NAME",
              "TYPE",
              "STATUS",
              "CONDITION",
              "HOST",
              "UPTIME",
              "VERSION",
              "CLASS",
              "INBOX",
              "DROPS",
              "REPLACED",
              "REFUSED",
              "OVERRUNS",
              "P99",
              "LAST ERROR");
      for (ServiceRow row : rows) {
        table.add(
            row.name(),
            row.type(),
            row.status(),
            row.conditionText(),
            row.discovery().map(DiscoveryResponse::host).orElse(""),
            row.discovery().map(response -> uptime(response.uptime())).orElse(""),
            row.discovery().map(DiscoveryResponse::version).orElse(""),
            row.simpleClassName(),
            count(row, HealthReport::inboxDepth),
            count(row, HealthReport::dropped),
            replaced(row),
            count(row, HealthReport::refused),
            count(row, HealthReport::overruns),
            duration(row.callbackP99S()),
            row.lastError());
      }
      return table.lines();
    }

    /** Empty if a service of an older version or in another language does not count them. */
    private static String replaced(ServiceRow row) {
      OptionalLong count = row.health().map(HealthReport::replaced).orElse(OptionalLong.empty());
      return count.isPresent() ? String.valueOf(count.getAsLong()) : "";
    }

    private static String count(ServiceRow row, ToLongFunction<HealthReport> of) {
      return row.health().map(report -> String.valueOf(of.applyAsLong(report))).orElse("");
    }

    /** Seconds below a minute, else hours:minutes:seconds. */
    static String uptime(double seconds) {
      if (seconds < SECONDS_PER_MINUTE) {
        return String.format(Locale.ROOT, "%.1f s", seconds);
      }
      long whole = (long) seconds;
      return String.format(Locale.ROOT, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
    }

    private static String duration(OptionalDouble seconds) {
      if (seconds.isEmpty()) {
        return "";
      }
      double value = seconds.getAsDouble();
      return value < 1e-3
          ? String.format(Locale.ROOT, "%.0f us", value * MICROS_PER_SECOND)
          : String.format(Locale.ROOT, "%.1f ms", value * MILLIS_PER_SECOND);
    }
  }
}
