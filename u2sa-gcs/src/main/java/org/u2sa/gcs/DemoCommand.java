package org.u2sa.gcs;

import java.io.PrintWriter;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/**
 * {@code u2sa demo}: lists the demos that the modules on the class path contribute; each is a
 * sub-command of it.
 */
@Command(
    name = "demo",
    description = "Run simulated vehicles on missions. Alone: list the demos.",
    synopsisSubcommandLabel = "[<demo> [<options>]]",
    commandListHeading = "%n@|bold DEMOS|@%n")
final class DemoCommand implements Runnable {

  @Spec private CommandSpec spec;

  @Override
  public void run() {
    CommandLine me = spec.commandLine();
    PrintWriter out = me.getOut();
    Map<String, CommandLine> demos = me.getSubcommands();
    if (demos.isEmpty()) {
      out.println("No demos: no module on the class path contributes one.");
      return;
    }
    out.println("Demos:");
    int width = demos.keySet().stream().mapToInt(String::length).max().orElse(0);
    demos.forEach(
        (name, demo) -> out.println("  u2sa demo " + padded(name, width) + "  " + firstLine(demo)));
    out.println();
    out.println("u2sa demo <demo> --help tells its options.");
  }

  private static String padded(String text, int width) {
    return text + " ".repeat(width - text.length());
  }

  private static String firstLine(CommandLine demo) {
    String[] description = demo.getCommandSpec().usageMessage().description();
    return description.length == 0 ? "" : demo.getColorScheme().text(description[0]).toString();
  }
}
