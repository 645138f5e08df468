package org.u2sa.core.safety;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.disk.LoadedFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.xml.XmlText;

/** The file named by the variable FENCE; detects changes since loading. */
final class FenceFile {
  private final XmlConfiguration configuration;
  private final Clock clock;
  private Optional<LoadedFile<GivenFence>> loaded = Optional.empty();

  FenceFile(XmlConfiguration configuration, Clock clock) {
    this.configuration = configuration;
    this.clock = clock;
  }

  /**
   * Fence described by the variables, shrunk by its margin; empty if they name none.
   *
   * @throws BadInputException naming the variable, the file and the error
   */
  Optional<GivenFence> load(SafetyVariables settings) {
    String path = settings.fence();
    double marginM = settings.fenceMargin();
    loaded =
        path.isEmpty()
            ? Optional.empty()
            : Optional.of(
                new LoadedFile<>(configuration.resolve(path), each -> read(each, marginM), clock));
    return loaded.map(LoadedFile::content);
  }

  /** {@link #load} without watching the file. */
  Optional<GivenFence> read(SafetyVariables settings) {
    String path = settings.fence();
    return path.isEmpty()
        ? Optional.empty()
        : Optional.of(
            LoadedFile.read(
                configuration.resolve(path), each -> read(each, settings.fenceMargin()), clock));
  }

  /** Stops watching the file, because another fence is in force. */
  void forget() {
    loaded = Optional.empty();
  }

  private static GivenFence read(Path file, double marginM) {
    try {
      return GivenFence.of(file.toString(), XmlText.read(file).text(), marginM);
    } catch (BadInputException e) {
      throw new BadInputException(
          "variable \"" + SafetyVariables.FENCE + "\": " + e.getMessage(), e);
    }
  }

  /**
   * Reason why the fence named by these values is invalid, or empty.
   *
   * @param before current values; an unchanged fence is not read again
   */
  Optional<String> refusal(Map<String, Object> values, SafetyVariables before) {
    String path = (String) values.get(SafetyVariables.FENCE);
    double marginM = (Double) values.get(SafetyVariables.FENCE_MARGIN);
    boolean same = path.equals(before.fence()) && marginM == before.fenceMargin();
    if (path.isEmpty() || same) {
      return Optional.empty();
    }
    try {
      read(configuration.resolve(path), marginM);
      return Optional.empty();
    } catch (BadInputException e) {
      return Optional.of(e.getMessage());
    }
  }

  /** Fault of the file; empty if unchanged since loading. */
  Optional<String> fault() {
    return loaded.flatMap(LoadedFile::fault);
  }
}
