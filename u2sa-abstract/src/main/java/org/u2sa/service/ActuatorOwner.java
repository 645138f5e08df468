package org.u2sa.service;

import java.util.List;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/** A service with actuators, which knows before it runs what control systems will be told. */
public interface ActuatorOwner {
  /** What it announces of each actuator when it begins, as its configuration is now. */
  List<ActuatorAnnouncement> actuators();
}
