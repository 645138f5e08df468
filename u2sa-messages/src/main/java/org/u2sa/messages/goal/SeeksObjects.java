package org.u2sa.messages.goal;

import java.util.Set;

/**
 * A goal whose task needs certain objects to be seen. Sensors that process data depending on the
 * task (thesis 4.3.2) look for these while the goal is current, and for nothing else.
 */
public interface SeeksObjects {
  /** Names of the object classes, such as "Buoy"; empty if the task needs none. */
  Set<String> soughtObjects();
}
