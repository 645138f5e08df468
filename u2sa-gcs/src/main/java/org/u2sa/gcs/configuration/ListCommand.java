package org.u2sa.gcs.configuration;

import java.util.List;
import java.util.concurrent.Callable;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.command.RunFailedException;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ConfigurationResponse;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code u2sa config list}. */
@Command(
    name = "list",
    description = {
      "List the variables with value, type, what is allowed, and meaning.",
      "",
      "Ends when every service found has answered, or after --timeout."
    })
final class ListCommand implements Callable<Integer> {
  @Mixin private RemoteSystem remote;
  @Mixin private AnswerFormat format;

  @Parameters(
      arity = "0..1",
      paramLabel = "SERVICE",
      description = "The service. Default: all of them.")
  private String service;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      List<ConfigurationResponse> answers =
          service == null ? configuration.all() : List.of(configuration.of(service));
      if (answers.isEmpty()) {
        throw new RunFailedException(
            "no service of system \""
                + link.systemId()
                + "\" answered within "
                + link.timeoutS()
                + " s");
      }
      format.print(
          () -> ConfigurationJson.text(link.systemId(), answers),
          () -> ConfigurationTable.lines(answers));
      return ExitCode.DONE;
    }
  }
}
