package org.u2sa.trials.run;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.sim.file.VehicleFile;
import picocli.CommandLine.Option;

/** Option {@code --change} of commands with a vehicle file. */
public final class VehicleFileChanges {
  @Option(
      names = "--change",
      paramLabel = "PATH=VALUE",
      description =
          "Override a value of the vehicle file, such as body/mass=25, gps/@preset=phone or laser/failsAt=60. May be given several times.")
  private Map<String, String> changes = new LinkedHashMap<>();

  /**
   * Reads a vehicle file with these changes.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line, field, value and expectation
   */
  public VehicleFile load(Path file) {
    return load(file, Map.of());
  }

  /**
   * Reads a vehicle file with a demo's changes and then these, which take precedence.
   *
   * @throws org.u2sa.interfaces.BadInputException as above
   */
  public VehicleFile load(Path file, Map<String, String> own) {
    Map<String, String> all = new LinkedHashMap<>(own);
    all.putAll(changes);
    return VehicleFile.load(file, all);
  }
}
