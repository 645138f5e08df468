package org.u2sa.cli.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.gcs.configuration.ConfigurationJson;
import org.u2sa.gcs.configuration.RemoteConfiguration;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/**
 * {@code u2sa config}: prints its help; list, get, set and undo are methods, export and import
 * classes.
 */
@Command(
    name = "config",
    description = {
      "Show and change the variables of a running system's services.",
      "",
      "  ./u2sa config list PathPlanner",
      "  ./u2sa config set PathPlanner \"LOITER RADIUS=500\" \"AT END=HOLD\"",
      "  ./u2sa config undo PathPlanner",
      "  ./u2sa config export rover.params"
    },
    subcommands = {ParameterFileCommand.Export.class, ParameterFileCommand.Import.class})
public final class ConfigCommand extends BaseCommand.Group {

  @Command(
      name = "list",
      description = {
        "List the variables with value, type, allowed values and meaning.",
        "",
        "Ends when every discovered service has answered, or after --timeout."
      })
  Integer list(
      @Parameters(
              arity = "0..1",
              paramLabel = "SERVICE",
              description = "The service. Default: all.")
          String service,
      @Mixin RemoteSystem remote,
      @Mixin AnswerFormat format)
      throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      List<ConfigurationResponse> answers =
          service == null ? configuration.all() : List.of(configuration.of(service));
      if (answers.isEmpty()) {
        throw new RunFailedException(
            String.format(
                "no service of system \"%s\" answered within %s s",
                link.systemId(), link.timeoutS()));
      }
      if (service == null) {
        configuration.silent().forEach(each -> tell("no answer from " + each));
      }
      format.print(
          () -> ConfigurationJson.text(link.systemId(), answers),
          () -> ConfigurationTable.lines(answers));
      return ExitCode.DONE;
    }
  }

  @Command(
      name = "get",
      description = {
        "Print the value of a variable and its unit.",
        "",
        "With --json: also type, range and description."
      })
  Integer get(
      @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.") String service,
      @Parameters(index = "1", paramLabel = "VARIABLE", description = "The variable's name.")
          String variable,
      @Mixin RemoteSystem remote,
      @Mixin AnswerFormat format)
      throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      ConfigurationVariable found =
          RemoteConfiguration.variable(new RemoteConfiguration(link).of(service), variable);
      format.print(
          () -> ConfigurationJson.text(found), () -> List.of(ConfigurationTable.value(found)));
      return ExitCode.DONE;
    }
  }

  @Command(
      name = "set",
      description = {
        "Change one or several variables atomically: all of them or none.",
        "",
        "A number may have a unit: \"BANK LIMIT=25 deg\". The service writes the new values to its file."
      })
  Integer set(
      @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.") String service,
      @Parameters(
              index = "1..*",
              arity = "1..*",
              paramLabel = "VARIABLE=VALUE",
              description = "The variables and their new values.")
          List<String> assignments,
      @Option(
              names = "--revision",
              paramLabel = "N",
              description = "Change nothing unless the configuration is still at this revision.")
          Long revision,
      @Mixin RemoteSystem remote,
      @Mixin AnswerFormat format)
      throws InterruptedException {
    List<VariableText> wanted = new ArrayList<>();
    for (String assignment : assignments) {
      try {
        wanted.add(VariableText.parse(assignment));
      } catch (IllegalArgumentException e) {
        throw new ParameterException(format.commandLine(), e.getMessage(), e);
      }
    }
    if (revision != null && revision < 0) {
      throw new ParameterException(
          format.commandLine(), "--revision " + revision + ": expected 0 or more");
    }
    try (RemoteLink link = remote.connectForOrders()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      ConfigurationResponse before = configuration.of(service);
      ConfigurationTransaction transaction =
          new ConfigurationTransaction()
              .serviceName(service)
              .assignments(inItsUnits(wanted, before));
      if (revision != null) {
        transaction.revision(revision);
      }
      return report(configuration.change(transaction), before, format);
    } catch (RunFailedException e) {
      remote.explainRefusal();
      throw e;
    }
  }

  private static List<ConfigurationAssignment> inItsUnits(
      List<VariableText> wanted, ConfigurationResponse before) {
    List<ConfigurationAssignment> all = new ArrayList<>();
    for (VariableText one : wanted) {
      ConfigurationVariable declared = RemoteConfiguration.variable(before, one.variable());
      all.add(
          new ConfigurationAssignment()
              .variableName(one.variable())
              .value(one.valueFor(declared, before.serviceName())));
    }
    return all;
  }

  @Command(
      name = "undo",
      description = {
        "Undo the latest change of a service's variables, whoever made it.",
        "",
        "Run it again to undo the change before that."
      })
  Integer undo(
      @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.") String service,
      @Mixin RemoteSystem remote,
      @Mixin AnswerFormat format)
      throws InterruptedException {
    try (RemoteLink link = remote.connectForOrders()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      ConfigurationResponse before = configuration.of(service);
      return report(configuration.undo(service), before, format);
    } catch (RunFailedException e) {
      remote.explainRefusal();
      throw e;
    }
  }

  private static int report(
      ConfigurationTransactionResult result, ConfigurationResponse before, AnswerFormat format) {
    format.print(
        () -> ConfigurationJson.text(result), () -> RemoteConfiguration.told(result, before));
    return ExitCode.DONE;
  }

  private static final class ConfigurationTable {
    private static final double WHOLE_BELOW = 1.0e15;

    private ConfigurationTable() {}

    /** A heading line per service, followed by its variables. */
    static List<String> lines(List<ConfigurationResponse> services) {
      List<String> lines = new ArrayList<>();
      for (ConfigurationResponse service : services) {
        if (!lines.isEmpty()) {
          lines.add("");
        }
        String revision =
            service.revision().isPresent()
                ? " (revision " + service.revision().getAsLong() + ")"
                : "";
        lines.add(service.serviceName() + revision);
        TextTable table = new TextTable("VARIABLE", "VALUE", "TYPE", "ALLOWED", "MEANING");
        for (ConfigurationVariable variable : service.variables()) {
          table.add(
              variable.name(),
              value(variable),
              variable.variableType(),
              allowed(variable),
              variable.description());
        }
        table.lines().forEach(line -> lines.add("  " + line));
      }
      return lines;
    }

    static String value(ConfigurationVariable variable) {
      return variable.unit().isEmpty()
          ? variable.value()
          : variable.value() + " " + variable.unit();
    }

    private static String allowed(ConfigurationVariable variable) {
      if (!variable.choices().isEmpty()) {
        return String.join(" | ", variable.choices());
      }
      OptionalDouble min = variable.min();
      OptionalDouble max = variable.max();
      if (min.isPresent() && max.isPresent()) {
        return number(min.getAsDouble()) + "…" + number(max.getAsDouble());
      }
      if (min.isPresent()) {
        return "from " + number(min.getAsDouble());
      }
      return max.isPresent() ? "up to " + number(max.getAsDouble()) : "";
    }

    private static String number(double value) {
      return value == Math.rint(value) && Math.abs(value) < WHOLE_BELOW
          ? Long.toString((long) value)
          : Double.toString(value);
    }
  }
}
