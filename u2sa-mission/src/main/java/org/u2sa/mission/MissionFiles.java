package org.u2sa.mission;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.disk.LoadedFile;
import org.u2sa.service.ServiceContext;

/**
 * Reads the mission files named by variables of the {@link MissionManager}, and detects when one
 * has changed since loading.
 */
final class MissionFiles {
  private static final List<String> VARIABLES =
      List.of(
          MissionVariables.MISSION, MissionVariables.RETURN_MISSION, MissionVariables.LAND_MISSION);

  private final ServiceContext context;

  private record Content(Mission mission, String digest) {}

  private final Map<String, LoadedFile<Content>> loaded = new TreeMap<>(); // by variable
  private List<String> said = List.of();

  MissionFiles(ServiceContext context) {
    this.context = context;
  }

  /** Reads a mission file and monitors it from now on, instead of the variable's previous file. */
  Mission load(String variable, String path, double thresholdM) {
    LoadedFile<Content> file =
        new LoadedFile<>(
            context.configuration().resolve(path),
            each -> new Content(read(variable, each, thresholdM), SavedMission.digest(each)),
            context.clock());
    loaded.put(variable, file);
    return file.content().mission();
  }

  /** Digest of the file of MISSION as loaded: it may be edited while the mission runs. */
  String digest() {
    return loaded.get(MissionVariables.MISSION).content().digest();
  }

  void forget(String variable) {
    loaded.remove(variable);
  }

  private Mission read(String variable, Path file, double thresholdM) {
    try {
      return Mission.load(file, context.messageTypes(), thresholdM);
    } catch (BadInputException e) {
      if (variable.equals(MissionVariables.MISSION)) {
        throw e; // the main mission file needs no further context
      }
      throw new BadInputException("variable \"" + variable + "\": " + e.getMessage(), e);
    }
  }

  /** Current faults of the files; marks them as reported. */
  List<String> faults() {
    List<String> faults = new ArrayList<>();
    loaded.forEach(
        (variable, file) -> file.fault().ifPresent(fault -> faults.add(variable + ": " + fault)));
    said = faults;
    return faults;
  }

  /** Whether {@link #faults} has changed since the last call. */
  boolean haveNews() {
    List<String> before = said;
    return !faults().equals(before);
  }

  /**
   * Why a file named by these values cannot be loaded; empty if all can.
   *
   * @param before current values, whose files are not re-read
   */
  Optional<String> refusal(Map<String, Object> values, Configurator before) {
    double thresholdM = (Double) values.get(MissionVariables.DEFAULT_THRESHOLD);
    boolean others = thresholdM != (Double) before.getVariable(MissionVariables.DEFAULT_THRESHOLD);
    try {
      for (String variable : VARIABLES) {
        String path = (String) values.get(variable);
        boolean named = variable.equals(MissionVariables.MISSION) || !path.isEmpty();
        if (named && (others || !path.equals(before.getVariable(variable)))) {
          read(variable, context.configuration().resolve(path), thresholdM);
        }
      }
    } catch (BadInputException e) {
      return Optional.of(e.getMessage());
    }
    return Optional.empty();
  }
}
