package org.u2sa.gcs.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa config set}. */
@Command(
    name = "set",
    description = {
      "Change one or several variables at once: all of them or none.",
      "",
      "A number may name its unit: \"BANK LIMIT=25 deg\". The service writes the new values to its file."
    })
final class SetCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;
  @Mixin private AnswerFormat format;

  @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.")
  private String service;

  @Parameters(
      index = "1..*",
      arity = "1..*",
      paramLabel = "VARIABLE=VALUE",
      description = "The variables and their new values.")
  private List<String> assignments;

  @Option(
      names = "--revision",
      paramLabel = "N",
      description = "Change nothing if the configuration is no longer at this revision.")
  private Long revision;

  @Override
  public Integer call() throws InterruptedException {
    List<VariableText> wanted = new ArrayList<>();
    for (String assignment : assignments) {
      try {
        wanted.add(VariableText.parse(assignment));
      } catch (IllegalArgumentException e) {
        throw new ParameterException(command.commandLine(), e.getMessage(), e);
      }
    }
    if (revision != null && revision < 0) {
      throw new ParameterException(
          command.commandLine(), "--revision " + revision + ": expected 0 or more");
    }
    try (RemoteLink link = remote.connect()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      ConfigurationResponse before = configuration.of(service);
      ConfigurationTransaction transaction =
          new ConfigurationTransaction()
              .serviceName(service)
              .assignments(inItsUnits(wanted, before));
      if (revision != null) {
        transaction.revision(revision);
      }
      ConfigurationTransactionResult result = configuration.change(transaction);
      format.print(
          () -> ConfigurationJson.text(result), () -> RemoteConfiguration.told(result, before));
      return ExitCode.DONE;
    }
  }

  private static List<ConfigurationAssignment> inItsUnits(
      List<VariableText> wanted, ConfigurationResponse before) {
    List<ConfigurationAssignment> all = new ArrayList<>();
    for (VariableText one : wanted) {
      all.add(
          new ConfigurationAssignment()
              .variableName(one.variable())
              .value(
                  one.valueFor(
                      RemoteConfiguration.variable(before, one.variable()), before.serviceName())));
    }
    return all;
  }
}
