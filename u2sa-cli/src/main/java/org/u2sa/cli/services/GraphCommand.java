package org.u2sa.cli.services;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.gcs.services.ServiceGraph;
import org.u2sa.gcs.services.SettledObservation;
import org.u2sa.interfaces.RunFailedException;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa graph}: shows the data flow between the services of a running system. */
@Command(
    name = "graph",
    description = {
      "Show which service feeds which in a running system, and data without a publisher or subscriber.",
      "",
      "  ./u2sa graph",
      "  ./u2sa graph --broker vehicle.local --dot | dot -Tsvg > system.svg",
      "",
      "Omitted: the channels that every service uses (discovery, functionality, stop, configuration, "
          + "health)."
    })
public final class GraphCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;
  @ArgGroup private Form form = new Form();

  private static final class Form {
    @Option(
        names = "--format",
        description = "Output format, one of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
    private Format format = Format.TEXT;

    @Option(names = "--dot", description = "Same as --format dot.")
    private boolean dot;

    @Option(names = "--json", description = "Same as --format json.")
    private boolean json;

    Format chosen() {
      return json ? Format.JSON : dot ? Format.DOT : format;
    }
  }

  private enum Format {
    TEXT,
    MERMAID,
    DOT,
    JSON
  }

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      SettledObservation settled = SettledObservation.made(link);
      DirectoryObservation observation = settled.observation();
      if (observation.names().isEmpty()) {
        throw new RunFailedException(
            String.format(
                "no service of system \"%s\" answers at %s",
                link.systemId(), remote.brokerAddress()));
      }
      ServiceGraph graph = ServiceGraph.of(observation.directory().services());
      if (!settled.hasSettled()) {
        tell(link);
      }
      lines(link.systemId(), graph).forEach(out()::println);
      return ExitCode.DONE;
    }
  }

  private List<String> lines(String systemId, ServiceGraph graph) {
    return switch (form.chosen()) {
      case TEXT -> GraphText.lines(graph);
      case MERMAID -> GraphText.mermaid(graph);
      case DOT -> GraphText.dot(systemId, graph);
      case JSON -> List.of(GraphText.json(systemId, graph));
    };
  }

  private void tell(RemoteLink link) {
    PrintWriter err = commandLine().getErr();
    err.printf(
        Locale.ROOT,
        "System \"%s\" did not settle within %.1f s: services and feeds may be missing; "
            + "--timeout waits longer%n",
        link.systemId(),
        link.timeoutS());
  }
}
