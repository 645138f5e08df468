package org.u2sa.gcs.configuration;

import java.util.concurrent.Callable;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code u2sa config undo}. */
@Command(
    name = "undo",
    description = {
      "Undo the latest change of a service's variables, whoever made it.",
      "",
      "Run it again to undo the change before that."
    })
final class UndoCommand implements Callable<Integer> {
  @Mixin private RemoteSystem remote;
  @Mixin private AnswerFormat format;

  @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.")
  private String service;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      ConfigurationResponse before = configuration.of(service);
      ConfigurationTransactionResult result = configuration.undo(service);
      format.print(
          () -> ConfigurationJson.text(result), () -> RemoteConfiguration.told(result, before));
      return ExitCode.DONE;
    }
  }
}
