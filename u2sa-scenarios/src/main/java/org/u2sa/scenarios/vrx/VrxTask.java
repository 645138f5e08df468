package org.u2sa.scenarios.vrx;

/** Tasks of VRX that the demo runs, each with the scoring plugin that names it in a world. */
enum VrxTask {
  /** Keep a position and a heading. */
  STATIONKEEPING("StationkeepingScoringPlugin", false),
  /** Visit positions with headings. */
  WAYFINDING("WayfindingScoringPlugin", false),
  /** Pass gates in order, among obstacles. */
  PATH("NavigationScoringPlugin", true),
  /** Circle some animals and keep away from others. */
  WILDLIFE("WildlifeScoringPlugin", false),
  /** Read a light buoy and dock in the bay that it designates. */
  DOCK("ScanDockScoringPlugin", true);

  private final String plugin;
  private final boolean isMoreBetter;

  VrxTask(String plugin, boolean isMoreBetter) {
    this.plugin = plugin;
    this.isMoreBetter = isMoreBetter;
  }

  /** Last part of the name of its scoring plugin. */
  String plugin() {
    return plugin;
  }

  /** Whether its score is an error far below 1. */
  boolean isFine() {
    return this == STATIONKEEPING || this == WAYFINDING;
  }

  /** Whether a higher score is better. */
  boolean isMoreBetter() {
    return isMoreBetter;
  }
}
