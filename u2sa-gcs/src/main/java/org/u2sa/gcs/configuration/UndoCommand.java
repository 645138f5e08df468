package org.u2sa.gcs.configuration;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.u2sa.gcs.ExitCode;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa config undo}. */
@Command(
    name = "undo",
    description = {
      "Take the newest change of a service's variables back, whoever made it.",
      "",
      "Once more takes the one before it back."
    })
final class UndoCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.")
  private String service;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      RemoteConfiguration configuration = new RemoteConfiguration(link);
      ConfigurationResponse before = configuration.of(service);
      ConfigurationTransactionResult result = configuration.undo(service);
      PrintWriter out = command.commandLine().getOut();
      if (json) {
        out.println(ConfigurationJson.text(result));
      } else {
        RemoteConfiguration.told(result, before).forEach(out::println);
      }
      out.flush();
      return ExitCode.DONE;
    }
  }
}
