package org.u2sa.fuzz;

import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * Configuration files: read, described, and each variable written with the value that it has, after
 * which the file must say the same.
 */
public final class ConfigurationTarget {
  private ConfigurationTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      XmlConfiguration configuration = XmlConfiguration.load(file.path());
      for (ConfigurationVariable variable : configuration.describe()) {
        Agreement.require(variable.serialize().length > 0, "bytes", 0, "some");
      }
      for (Map.Entry<String, Object> field : configuration.enumerateFields()) {
        Optional<String> refusal = configuration.change(field.getKey(), field.getValue());
        if (refusal.isEmpty()) {
          Object now = XmlConfiguration.load(file.path()).getVariable(field.getKey());
          Agreement.require(now.equals(field.getValue()), "written", now, field.getValue());
        }
      }
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }
}
