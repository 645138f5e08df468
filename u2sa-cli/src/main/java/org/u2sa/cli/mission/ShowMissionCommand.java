package org.u2sa.cli.mission;

import java.io.PrintWriter;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.gcs.mission.MissionJson;
import org.u2sa.gcs.mission.MissionView;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa mission show}. */
@Command(
    name = "show",
    description = {"Show the goals of the mission: result, time, distance and successors of each."})
final class ShowMissionCommand implements Callable<Integer> {
  /** Time to wait for a state; several publishing periods [s]. */
  private static final double STATE_WITHIN_S = 0.6;

  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      AtomicReference<StateInformation> state = new AtomicReference<>();
      link.listen(Channels.STATE, state::set);
      MissionReport report = report(link);
      link.await(() -> state.get() != null, Math.min(STATE_WITHIN_S, link.timeoutS()));
      print(link.systemId(), new MissionView(report, Optional.ofNullable(state.get())));
      return ExitCode.DONE;
    }
  }

  private MissionReport report(RemoteLink link) throws InterruptedException {
    String id = UUID.randomUUID().toString();
    Optional<MissionReport> report =
        link.first(
            Channels.MISSION,
            new MissionRequest().requestId(id),
            MissionReport.class,
            each -> each.requestId().equals(id));
    if (report.isEmpty()) {
      throw OrderToMissionManager.nobody(remote, link);
    }
    return report.get();
  }

  private void print(String systemId, MissionView mission) {
    PrintWriter out = command.commandLine().getOut();
    if (json) {
      out.print(MissionJson.text(systemId, mission)); // contains its own line breaks
      out.println();
    } else {
      Terminal terminal = Terminal.detect(out, System.getenv());
      MissionTable.lines(systemId, mission, terminal).forEach(out::println);
    }
  }
}
