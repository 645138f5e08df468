package org.u2sa.cli.configuration;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.configuration.RemoteConfiguration;
import org.u2sa.gcs.mavlink.parameter.ParameterFile;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.report.ReportFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Parameter files of ground stations, written from and read into a running system. */
abstract class ParameterFileCommand extends BaseCommand {
  private static final long LONGEST = 4L << 20; // bytes
  private static final String QGC = ".params";

  @Mixin private RemoteSystem remote;

  @Parameters(paramLabel = "FILE", description = "The parameter file.")
  private Path file;

  Path file() {
    return file;
  }

  @Override
  public final Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connectForOrders()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      List<ConfigurationResponse> all = configuration.all();
      if (all.isEmpty()) {
        throw remote.unanswered(link, "no service of system \"" + link.systemId() + "\" answered");
      }
      if (!configuration.silent().isEmpty()) {
        throw new RunFailedException(
            String.format(
                "no answer within %s s from %s; expected one from each service, try a longer --timeout",
                link.timeoutS(), String.join(", ", configuration.silent())));
      }
      run(configuration, all);
      return ExitCode.DONE;
    } catch (RunFailedException e) {
      remote.explainRefusal();
      throw e;
    }
  }

  abstract void run(RemoteConfiguration configuration, List<ConfigurationResponse> all)
      throws InterruptedException;

  /** {@code u2sa config export}. */
  @Command(
      name = "export",
      description = {
        "Write the variables of all services to a parameter file for ground stations.",
        "",
        "  ./u2sa config export rover.params    QGroundControl",
        "  ./u2sa config export rover.parm      Mission Planner, MAVProxy",
        "",
        "Names and values are as in docs/mavlink.md; text variables, such as file names, are omitted."
      })
  static final class Export extends ParameterFileCommand {
    @Override
    void run(RemoteConfiguration configuration, List<ConfigurationResponse> all) {
      ParameterFile parameters = new ParameterFile(all);
      boolean isQgc = file().toString().endsWith(QGC);
      ReportFile.writeText(
          file(), writer -> writer.write(isQgc ? parameters.params() : parameters.parm()));
      print(file() + " (" + parameters.size() + " parameters)");
    }
  }

  /** {@code u2sa config import}. */
  @Command(
      name = "import",
      description = {
        "Set the variables listed in a ground station's parameter file: .params or .parm.",
        "",
        "Nothing is changed if a name, value or range is wrong. Otherwise each service changes "
            + "all its variables or none, and writes them to its file."
      })
  static final class Import extends ParameterFileCommand {
    @Override
    void run(RemoteConfiguration configuration, List<ConfigurationResponse> all)
        throws InterruptedException {
      List<ConfigurationTransaction> changes =
          new ParameterFile(all).changes(file().toString(), content());
      if (changes.isEmpty()) {
        print("Nothing to change: the system has these values.");
      }
      for (ConfigurationTransaction each : changes) {
        ConfigurationResponse before =
            all.stream()
                .filter(one -> one.serviceName().equals(each.serviceName()))
                .findFirst()
                .orElseThrow();
        RemoteConfiguration.told(configuration.change(each), before).forEach(this::print);
      }
    }

    private String content() {
      try {
        RegularFile.require(file(), "a parameter file");
        if (Files.size(file()) > LONGEST) {
          throw new BadInputException(file() + ": expected a file of at most 4 MiB");
        }
        return Files.readString(file()).replaceFirst("^\uFEFF", ""); // byte-order mark
      } catch (CharacterCodingException e) {
        throw new BadInputException(file() + ": expected UTF-8 text", e);
      } catch (IOException e) {
        throw new BadInputException(file() + ": cannot be read: " + e, e);
      }
    }
  }
}
