package org.u2sa.network;

/** Take-off and three waypoints: 18 km, eight minutes, high enough to glide for a while. */
final class NetworkMission {
  static final String TEXT =
      """
      <mission>
        <home>
          <x>-157.943183</x>
          <y>21.325247</y>
          <z unit="ft">17.5</z>
          <psi>90.0</psi>
        </home>
        <waypoint>
          <name>1</name>
          <next>2</next>
          <reference>Global</reference>
          <x>-157.895000</x>
          <y>21.325239</y>
          <z unit="ft">1500</z>
          <horizontalThreshold>100</horizontalThreshold>
        </waypoint>
        <waypoint>
          <name>2</name>
          <next>3</next>
          <reference>Global</reference>
          <x>-157.890000</x>
          <y>21.250000</y>
          <z unit="ft">1500</z>
          <horizontalThreshold>100</horizontalThreshold>
        </waypoint>
        <waypoint>
          <name>3</name>
          <reference>Global</reference>
          <x>-157.940000</x>
          <y>21.250000</y>
          <z unit="ft">1500</z>
          <horizontalThreshold>100</horizontalThreshold>
        </waypoint>
      </mission>
      """;

  private NetworkMission() {}
}
