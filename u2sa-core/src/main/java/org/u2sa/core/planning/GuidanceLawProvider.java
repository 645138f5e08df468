package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Configurator;

/**
 * Brings a guidance law that the variable GUIDANCE of {@link PathPlanner} can name; found through
 * {@link java.util.ServiceLoader}.
 */
public interface GuidanceLawProvider {
  /** The value of GUIDANCE that chooses the law, in capitals, such as {@code VECTOR FIELD}. */
  String name();

  /**
   * A law for one planner.
   *
   * @param configuration the planner's, from which the law declares and reads variables
   */
  GuidanceLaw law(Configurator configuration);
}
