package org.u2sa.scenarios.camera;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds {@code u2sa camera} to the command line. */
public final class CameraCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new CameraCommand()));
  }
}
