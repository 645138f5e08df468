package org.u2sa.gcs.run;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.u2sa.gcs.command.CommandProvider;
import org.u2sa.gcs.configuration.ConfigCommand;
import org.u2sa.gcs.dependencies.DependenciesCommand;
import org.u2sa.gcs.describe.DescribeCommand;
import org.u2sa.gcs.doctor.DoctorCommand;
import org.u2sa.gcs.export.ExportCommand;
import org.u2sa.gcs.look.EchoCommand;
import org.u2sa.gcs.look.LogCommand;
import org.u2sa.gcs.look.MeasureCommand;
import org.u2sa.gcs.look.PlotCommand;
import org.u2sa.gcs.look.PublishCommand;
import org.u2sa.gcs.mission.MissionCommand;
import org.u2sa.gcs.record.RecordCommand;
import org.u2sa.gcs.record.RecoverCommand;
import org.u2sa.gcs.record.ReplayCommand;
import org.u2sa.gcs.report.CompareCommand;
import org.u2sa.gcs.report.ReportCommand;
import org.u2sa.gcs.safety.ArmingCommand;
import org.u2sa.gcs.safety.EmergencyStopCommand;
import org.u2sa.gcs.safety.OperatorCommand;
import org.u2sa.gcs.security.SecurityCommand;
import org.u2sa.gcs.services.GraphCommand;
import org.u2sa.gcs.services.LauncherCommand;
import org.u2sa.gcs.services.ServicesCommand;
import org.u2sa.gcs.services.StopServicesCommand;
import org.u2sa.gcs.template.NewCommand;
import org.u2sa.gcs.view.ViewCommand;

/** Adds the commands that run systems and operate running ones. */
public final class SystemCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return Stream.of(
            new RunCommand(),
            new RecordCommand(),
            new RecoverCommand(),
            new ReplayCommand(),
            new ExportCommand(),
            new ViewCommand(),
            new ReportCommand(),
            new CompareCommand(),
            new ConfigCommand(),
            new ServicesCommand(),
            new GraphCommand(),
            new EchoCommand(),
            new MeasureCommand.Rate(),
            new MeasureCommand.Delay(),
            new MeasureCommand.Bandwidth(),
            new PublishCommand(),
            new PlotCommand(),
            new LogCommand(),
            new StopServicesCommand(),
            new LauncherCommand.Restart(),
            new LauncherCommand.Swap(),
            new SecurityCommand(),
            new EmergencyStopCommand(),
            new ArmingCommand.Arm(),
            new ArmingCommand.Disarm(),
            new OperatorCommand(),
            new MissionCommand(),
            new DescribeCommand(),
            new DoctorCommand(),
            new DependenciesCommand(),
            new NewCommand(Path.of("")))
        .map(command -> new Contribution(Group.TOP_LEVEL, command))
        .toList();
  }
}
