package org.u2sa.vision.lane;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ModellerProvider;

/** Provides the World Modeler's {@code LINES} modeller: painted lane lines on the ground. */
public final class LineModellerProvider implements ModellerProvider {
  @Override
  public String name() {
    return "LINES";
  }

  @Override
  public Modeller modeller(Configurator configuration) {
    return new LineModeller(configuration);
  }
}
