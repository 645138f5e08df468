package org.u2sa.cli.configuration;

import java.io.PrintWriter;
import java.util.List;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Output format of a command: text lines or JSON. */
final class AnswerFormat {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  CommandLine commandLine() {
    return command.commandLine();
  }

  void print(Supplier<String> asJson, Supplier<List<String>> asLines) {
    PrintWriter out = command.commandLine().getOut();
    if (json) {
      out.print(asJson.get()); // contains its own line breaks
      out.println();
    } else {
      asLines.get().forEach(out::println);
    }
  }
}
