package org.u2sa.cli.doctor;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.gcs.remote.BrokerAddress;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.time.SystemClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa doctor}: checks this machine for what U2SA needs. */
@Command(
    name = "doctor",
    description = {
      "Check this machine: Java, memory, disk, ports, clock, serial ports, broker, tools.",
      "",
      "  ./u2sa doctor",
      "  ./u2sa doctor --broker vehicle.local --json",
      "",
      "Each line that is not ok states a remedy. A broker named by --broker must answer; "
          + "otherwise none needs to run.",
      "",
      "Exit code 0: no problems (optional items may be missing); 1: there is a warning or a "
          + "failure."
    })
public final class DoctorCommand extends BaseCommand {
  private static final int CONNECT_MS = 2_000;
  private static final int DEFAULT_PORT = 1883;

  @Mixin private RemoteSystem remote;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    List<Finding> findings = findings(System.getenv());
    if (json) {
      print(json(findings));
    } else {
      print(findings);
    }
    boolean bad =
        findings.stream().anyMatch(each -> each.grade().compareTo(Finding.Grade.WARNING) >= 0);
    return bad ? ExitCode.FAILED : ExitCode.DONE;
  }

  private List<Finding> findings(Map<String, String> environment) throws InterruptedException {
    MachineChecks machine = new MachineChecks(Path.of("/dev"));
    Finding broker = broker();
    boolean local = remote.brokerAddress().equals("localhost:" + DEFAULT_PORT);
    List<Finding> all =
        new ArrayList<>(
            List.of(
                Finding.ok("U2SA", ProgramVersion.text()),
                machine.java(),
                machine.memory(),
                machine.disk(Path.of("")),
                machine.clock(new SystemClock()),
                machine.port(DEFAULT_PORT, local && broker.grade() == Finding.Grade.OK),
                broker,
                machine.serialPorts()));
    all.addAll(new ToolChecks(new Programs(environment), environment).all());
    return all;
  }

  /** Whether a server accepts connections there; its permissions are checked elsewhere. */
  private Finding broker() {
    boolean named = commandLine().getParseResult().hasMatchedOption("--broker");
    String where = remote.brokerAddress();
    try (Socket socket = new Socket()) {
      BrokerAddress address = BrokerAddress.parse(where);
      socket.connect(new InetSocketAddress(address.host(), address.port()), CONNECT_MS);
      return Finding.ok("broker", where + " accepts connections");
    } catch (IllegalArgumentException e) {
      return Finding.optional(
          "broker",
          where + " is found by mDNS, which is not checked here",
          "name one: --broker HOST:PORT");
    } catch (IOException e) {
      String found = where + ": " + e.getMessage();
      return named
          ? Finding.failure(
              "broker",
              found,
              "start the system or its broker there; see docs/distribution.md for access from "
                  + "other hosts")
          : Finding.optional(
              "broker", found, "not needed until a system runs: ./u2sa demo cessna --realtime");
    }
  }

  private void print(List<Finding> findings) {
    Terminal terminal = terminal();
    int width = findings.stream().mapToInt(each -> each.subject().length()).max().orElse(0);
    for (Finding finding : findings) {
      String padded = finding.subject() + " ".repeat(width - finding.subject().length());
      print(mark(finding, terminal) + "  " + padded + "  " + finding.found());
      if (!finding.advice().isEmpty()) {
        print(" ".repeat(10 + width) + "→ " + finding.advice());
      }
    }
  }

  private static String mark(Finding finding, Terminal terminal) {
    return switch (finding.grade()) {
      case OK -> terminal.good("ok     ");
      case OPTIONAL -> "absent ";
      case WARNING -> terminal.bold("WARNING");
      case FAILURE -> terminal.bad("FAILURE");
    };
  }

  private static String json(List<Finding> findings) {
    return new JsonText().put("findings", findings.stream().map(Finding::json).toList()).toString();
  }
}
