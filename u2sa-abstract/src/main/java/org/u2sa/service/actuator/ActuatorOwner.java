package org.u2sa.service.actuator;

import java.util.List;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/** A service with actuators that can provide its announcements before it runs. */
public interface ActuatorOwner {
  /** Initial announcement of each actuator. */
  List<ActuatorAnnouncement> actuators();
}
