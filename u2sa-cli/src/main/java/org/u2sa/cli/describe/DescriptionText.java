package org.u2sa.cli.describe;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.cli.describe.VehicleComposition.ComposedService;
import org.u2sa.cli.describe.VehicleComposition.HeardSource;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.control.allocation.Authority;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.control.allocation.Effector;
import org.u2sa.core.launch.AutonomyLevels.Level;

/** Formats a vehicle's composition as text. */
final class DescriptionText {
  private static final double MIN_STRENGTH = 1e-6; // [N, N m]: rounding

  private final VehicleComposition vehicle;
  private final Terminal terminal;
  private final boolean variables;
  private final List<String> lines = new ArrayList<>();

  DescriptionText(VehicleComposition vehicle, Terminal terminal, boolean variables) {
    this.vehicle = vehicle;
    this.terminal = terminal;
    this.variables = variables;
  }

  List<String> lines() {
    lines.add(
        terminal.bold("System " + vehicle.systemId())
            + (vehicle.live() ? " running at " : " by ")
            + vehicle.origin());
    words();
    autonomy();
    services();
    if (vehicle.live()) {
      sources();
    } else {
      statedSensors();
    }
    actuators();
    return lines;
  }

  private void words() {
    head("In words");
    lines.addAll(new DataFlowSummary(vehicle).sentences());
  }

  private void head(String text) {
    lines.add("");
    lines.add(terminal.bold(text));
  }

  private void autonomy() {
    head("Autonomy (levels 1 to 6 of thesis 2.3)");
    TextTable table = new TextTable("", "STATED", "SHOWN", "BY WHAT");
    List<AutonomyEvidence.Finding> findings = new AutonomyEvidence(vehicle).findings();
    for (AutonomyEvidence.Finding finding : findings) {
      table.add(
          finding.dimension(),
          finding.stated().map(DescriptionText::words).orElse("-"),
          words(finding.shown()),
          finding.because());
    }
    lines.addAll(table.lines());
    if (vehicle.services().stream().anyMatch(service -> service.role().isEmpty())) {
      lines.add(terminal.bad("Not all services could be queried; their evidence is missing."));
    }
    for (AutonomyEvidence.Finding finding : findings) {
      if (finding.isUnproven()) {
        lines.add(
            terminal.bad(
                "More "
                    + finding.dimension()
                    + " is stated than services and channels show: "
                    + words(finding.stated().orElseThrow())));
      }
    }
  }

  static String words(Level level) {
    return level.number() + " " + level.words();
  }

  private void services() {
    head("Services");
    for (ComposedService service : vehicle.services()) {
      lines.add(
          terminal.bold(service.name())
              + (service.role().isEmpty() ? "" : ", " + service.roleWords())
              + ", "
              + service.className());
      line("configuration", service.configuration());
      if (variables) {
        service.variables().forEach((name, value) -> lines.add("      " + name + " = " + value));
      }
      channels("hears", "from", service.subscribes(), vehicle::publishersOf, service);
      channels("publishes", "to", service.publishes(), vehicle::subscribersOf, service);
      if (!service.note().isEmpty()) {
        lines.add(terminal.bad("  " + service.note()));
      }
    }
  }

  private void line(String what, String text) {
    if (!text.isEmpty()) {
      lines.add(String.format(Locale.ROOT, "  %-15s%s", what, text));
    }
  }

  /** Channels with the services at their other end; unconnected channels on separate lines. */
  private void channels(
      String what,
      String direction,
      List<String> channels,
      Function<String, List<String>> ends,
      ComposedService self) {
    List<String> joined = new ArrayList<>();
    List<String> loose = new ArrayList<>();
    for (String channel : channels) {
      List<String> others = new ArrayList<>(ends.apply(channel));
      others.remove(self.name());
      if (others.isEmpty()) {
        loose.add(channel);
      } else {
        joined.add(channel + " " + direction + " " + String.join(", ", others));
      }
    }
    line(what, String.join("; ", joined));
    if (!loose.isEmpty()) {
      line(
          joined.isEmpty() ? what : "",
          String.join(", ", loose) + ": " + direction + " no service");
    }
  }

  private void sources() {
    head("Measured, and estimated from it");
    if (vehicle.sources().isEmpty()) {
      lines.add("no messages were received");
      return;
    }
    TextTable table =
        new TextTable("CHANNEL", "SENSOR", "TYPE", "RATE", "FIELDS", "STANDARD DEVIATIONS");
    for (HeardSource source : vehicle.sources()) {
      table.add(
          source.channel(),
          source.sensor(),
          source.type(),
          source.rateHz() > 0.0 ? String.format(Locale.ROOT, "%.1f Hz", source.rateHz()) : "once",
          String.join(" ", source.fields()),
          source.sigmas().isEmpty() ? "none" : pairs(source.sigmas(), " "));
    }
    lines.addAll(table.lines());
  }

  private void statedSensors() {
    head("Measurements, as configured");
    TextTable table = new TextTable("SERVICE", "STATED");
    for (ComposedService service : vehicle.services()) {
      if (!service.stated().isEmpty()) {
        table.add(service.name(), pairs(service.stated(), " "));
      }
    }
    lines.addAll(table.lines());
  }

  private void actuators() {
    head(vehicle.live() ? "Actuators" : "Actuators, as they would announce themselves");
    if (vehicle.actuators().isEmpty()) {
      lines.add(vehicle.live() ? "none announced" : "none");
    }
    for (AnnouncedActuator actuator : vehicle.actuators()) {
      lines.add(actuator.name() + ": " + pairs(actuator.facts(), " "));
    }
    String strength = strength();
    if (!strength.isEmpty()) {
      lines.add("Combined maximum of each axis alone, in its weaker direction: " + strength);
    } else if (!vehicle.actuators().isEmpty()) {
      lines.add("None announces a numeric effect (EFFECT), so control cannot allocate.");
    }
  }

  private static String pairs(Map<String, String> values, String equals) {
    List<String> pairs = new ArrayList<>();
    values.forEach((name, value) -> pairs.add(name + equals + value));
    return String.join(", ", pairs);
  }

  /**
   * Maximum forces and moments per axis, in the weaker direction, with no demand on the other axes;
   * empty if no actuator has a numeric effect.
   */
  private String strength() {
    List<Effector> effectors =
        vehicle.actuators().stream()
            .flatMap(each -> Effector.of(each.announcement()).stream())
            .toList();
    List<String> words = new ArrayList<>();
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      double most = Authority.of(effectors, Set.of(axis)).most(axis);
      if (most > MIN_STRENGTH) {
        String unit = axis.ordinal() < DegreeOfFreedom.ROLL.ordinal() ? "N" : "N m";
        words.add(String.format(Locale.ROOT, "%s %.1f %s", axis, most, unit));
      }
    }
    return String.join(", ", words);
  }
}
