package org.u2sa.control.fixedwing;

import java.nio.file.Path;
import java.nio.file.Paths;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** The gains of config/cessna/Control.xml, for flights without services. */
final class TestTuning {
  /** From a module's directory, where its tests run. */
  static final Path FILE = Paths.get("..", "config", "cessna", "Control.xml");

  private TestTuning() {}

  static AutopilotVariables standard() {
    return AutopilotVariables.in(XmlConfiguration.load(FILE)).get();
  }
}
