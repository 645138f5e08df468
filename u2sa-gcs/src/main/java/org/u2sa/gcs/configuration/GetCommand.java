package org.u2sa.gcs.configuration;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa config get}. */
@Command(name = "get", description = "Print the value of a variable and its unit.")
final class GetCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Parameters(index = "0", paramLabel = "SERVICE", description = "The service.")
  private String service;

  @Parameters(index = "1", paramLabel = "VARIABLE", description = "The variable's name.")
  private String variable;

  @Option(names = "--json", description = "Print JSON, with type, range and description.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      ConfigurationResponse response = new RemoteConfiguration(link).of(service);
      ConfigurationVariable found = RemoteConfiguration.variable(response, variable);
      PrintWriter out = command.commandLine().getOut();
      if (json) {
        out.print(ConfigurationJson.text(found));
        out.println();
      } else {
        out.println(ConfigurationTable.value(found));
      }
      return ExitCode.DONE;
    }
  }
}
