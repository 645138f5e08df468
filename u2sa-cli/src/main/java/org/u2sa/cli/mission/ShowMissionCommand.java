package org.u2sa.cli.mission;

import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.mission.MissionJson;
import org.u2sa.gcs.mission.MissionView;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa mission show}. */
@Command(
    name = "show",
    description = {"Show the goals of the mission: result, time, distance and successors of each."})
final class ShowMissionCommand extends BaseCommand {
  /** Time to wait for a state; several publishing periods [s]. */
  private static final double STATE_WITHIN_S = 0.6;

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
      throw remote.unanswered(link, nobody(link));
    }
    return report.get();
  }

  /** Message for a missing answer. */
  static String nobody(RemoteLink link) {
    return String.format(
        "%s: no Mission Manager answered within %s s; ./u2sa services shows whether one runs",
        link.systemId(), link.timeoutS());
  }

  private void print(String systemId, MissionView mission) {
    if (json) {
      printBlock(MissionJson.text(systemId, mission));
    } else {
      MissionTable.lines(systemId, mission, terminal()).forEach(out()::println);
    }
  }
}
