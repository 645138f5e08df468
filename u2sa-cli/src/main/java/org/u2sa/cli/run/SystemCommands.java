package org.u2sa.cli.run;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.u2sa.cli.command.CommandProvider;
import org.u2sa.cli.configuration.ConfigCommand;
import org.u2sa.cli.describe.DescribeCommand;
import org.u2sa.cli.doctor.DoctorCommand;
import org.u2sa.cli.look.EchoCommand;
import org.u2sa.cli.look.LogCommand;
import org.u2sa.cli.look.MeasureCommand;
import org.u2sa.cli.look.PlotCommand;
import org.u2sa.cli.look.PublishCommand;
import org.u2sa.cli.look.ViewCommand;
import org.u2sa.cli.mission.MissionCommand;
import org.u2sa.cli.record.RecordCommand;
import org.u2sa.cli.record.RecoverCommand;
import org.u2sa.cli.record.ReplayCommand;
import org.u2sa.cli.report.CompareCommand;
import org.u2sa.cli.report.ExportCommand;
import org.u2sa.cli.report.MosaicCommand;
import org.u2sa.cli.report.ReportCommand;
import org.u2sa.cli.safety.ArmingCommand;
import org.u2sa.cli.safety.EmergencyStopCommand;
import org.u2sa.cli.safety.OperatorCommand;
import org.u2sa.cli.security.SecurityCommand;
import org.u2sa.cli.services.GraphCommand;
import org.u2sa.cli.services.LauncherCommand;
import org.u2sa.cli.services.ServicesCommand;
import org.u2sa.cli.services.StopServicesCommand;
import org.u2sa.cli.template.NewCommand;

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
            new MosaicCommand(),
            new ViewCommand(),
            new MavlinkCommand(),
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
            new NewCommand(Path.of("")))
        .map(command -> new Contribution(Group.TOP_LEVEL, command))
        .toList();
  }
}
