package org.u2sa.world.modeller;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.world.WorldModeler;

/**
 * Brings a modeller that the variable MODELLERS of {@link WorldModeler} can name; found through
 * {@link java.util.ServiceLoader}.
 */
public interface ModellerProvider {
  /** The name in MODELLERS, in capitals, such as {@code SEA MARKS}. */
  String name();

  /**
   * A modeller for one World Modeler.
   *
   * @param configuration the World Modeler's, from which the modeller declares and reads variables
   */
  Modeller modeller(Configurator configuration);
}
