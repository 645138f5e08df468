package org.u2sa.gcs.ros;

import org.u2sa.core.communication.bridge.ClientBridge;
import org.u2sa.core.communication.bridge.ClientBridgeProvider;
import org.u2sa.interfaces.time.SystemClock;

/** Finds the rosbridge server for the Communication Manager. */
public final class RosbridgeProvider implements ClientBridgeProvider {
  @Override
  public String protocol() {
    return "rosbridge";
  }

  @Override
  public ClientBridge start(ClientBridge.Setting setting) {
    return new RosbridgeServer(setting, new SystemClock());
  }
}
