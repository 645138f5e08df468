package org.u2sa.world.modeller;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.world.WorldModeler;

/**
 * Provider of a modeller that can be selected with the variable MODELLERS of {@link WorldModeler};
 * found through {@link java.util.ServiceLoader}.
 */
public interface ModellerProvider {
  /** The name in MODELLERS, in capitals, such as {@code SEA MARKS}. */
  String name();

  /**
   * Creates a modeller for one World Modeler.
   *
   * @param configuration configuration of the World Modeler, in which the modeller declares and
   *     reads variables
   */
  Modeller modeller(Configurator configuration);
}
