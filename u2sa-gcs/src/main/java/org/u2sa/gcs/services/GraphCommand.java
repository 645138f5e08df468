package org.u2sa.gcs.services;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.command.ReportFile;
import org.u2sa.gcs.command.RunFailedException;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa graph}: who feeds whom in a running system. */
@Command(
    name = "graph",
    description = {
      "Show who feeds whom in a running system, and what nobody listens to or publishes.",
      "",
      "Left out: the channels on which every service talks with everybody (discovery, functionality, stop, configuration, "
          + "health)."
    })
public final class GraphCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;
  @ArgGroup private Form form = new Form();

  /** Only one at a time. */
  private static final class Form {
    @Option(names = "--dot", description = "Print the graph for Graphviz.")
    private boolean dot;

    @Option(names = "--svg", paramLabel = "FILE", description = "Write a picture (SVG).")
    private Path svg;
  }

  @Override
  public Integer call() throws InterruptedException {
    PrintWriter out = command.commandLine().getOut();
    try (RemoteLink link = remote.connect()) {
      SettledObservation settled = SettledObservation.made(link);
      DirectoryObservation observation = settled.observation();
      if (observation.names().isEmpty()) {
        throw new RunFailedException(
            "no service of system \""
                + link.systemId()
                + "\" answers at "
                + remote.brokerAddress());
      }
      ServiceGraph graph = ServiceGraph.of(observation.directory().services());
      if (!settled.hasSettled()) {
        tell(link);
      }
      if (form.dot) {
        GraphText.dot(link.systemId(), graph).forEach(out::println);
      } else if (form.svg != null) {
        String picture = GraphPicture.svg(link.systemId(), graph);
        ReportFile.writeText(form.svg, text -> text.write(picture));
        out.println("Written: " + form.svg);
      } else {
        GraphText.lines(graph).forEach(out::println);
      }
      out.flush();
      return ExitCode.DONE;
    }
  }

  private void tell(RemoteLink link) {
    PrintWriter err = command.commandLine().getErr();
    err.printf(
        Locale.ROOT,
        "System \"%s\" did not come to rest within %.1f s: services and feeds may be missing; "
            + "--timeout waits longer%n",
        link.systemId(),
        link.timeoutS());
    err.flush();
  }
}
