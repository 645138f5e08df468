package org.u2sa.planning.guidance;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.planning.PathPlanner;

/**
 * Provides a guidance law selectable by the variable GUIDANCE of {@link PathPlanner}; found through
 * {@link java.util.ServiceLoader}.
 */
public interface GuidanceLawProvider {
  /** Value of GUIDANCE that selects the law, in capitals, such as {@code VECTOR FIELD}. */
  String name();

  /**
   * Creates a law for one planner.
   *
   * @param configuration configuration of the planner, in which the law declares and reads
   *     variables
   */
  GuidanceLaw law(Configurator configuration);
}
