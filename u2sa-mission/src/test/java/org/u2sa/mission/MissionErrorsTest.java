package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;

class MissionErrorsTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          `` | m.xml, line 1, <mission>: contains no goals; expected at least one, such as <waypoint><x>…</x><y>…</y></waypoint>
          <home><x>8</x><y>50</y></home> | m.xml, line 1, <mission>: contains no goals; expected at least one, such as <waypoint><x>…</x><y>…</y></waypoint>
          <wayoint><x>1</x></wayoint> | m.xml, line 2, <wayoint>: unknown element in <mission>; expected home or a class of goals: waypoint, objectGoal, station, takeOff, landing, payloadDrop, searchArea; did you mean "waypoint"?
          <circle><x>1</x></circle> | m.xml, line 2, <circle>: is not a class of goals; expected one of waypoint, objectGoal, station, takeOff, landing, payloadDrop, searchArea
          <goalInformation><uid>1</uid></goalInformation> | m.xml, line 2, <goalInformation>: is abstract: no goal can be of this class; expected one of waypoint, objectGoal, station, takeOff, landing, payloadDrop, searchArea
          <objectGoal><name>1</name></objectGoal> | m.xml, line 2, <objectGoal>: lacks <objectType>; expected a value
          <objectGoal><objectType>barrel</objectType></objectGoal> | m.xml, line 2, <objectGoal>: lacks <within>; expected a number of m
          <searchArea><corners>1 1; 2 2</corners><resolution>0.05</resolution></searchArea> | m.xml, line 2, <corners>: corners: 2 of them; expected 3 to 200
          <waypoint><name>1</name></waypoint> | m.xml, line 2, <waypoint>: has no coordinates; expected at least one of x, y, z
          <waypoint><x>ten</x></waypoint> | m.xml, line 2, <x>: "ten" is not a number of deg
          <waypoint><x unit="deg">ten</x></waypoint> | m.xml, line 2, <x>: "ten" is not a number of deg
          <waypoint><x>1e999</x></waypoint> | m.xml, line 2, <x>: "1e999" is too large
          <waypoint><x>0x10</x></waypoint> | m.xml, line 2, <x>: "0x10" is not a number of deg
          <waypoint><x>1</x><speed>-1</speed></waypoint> | m.xml, line 2, <speed>: Waypoint.speed: expected at least 0.0 m/s, not "-1.0"
          <waypoint><x/></waypoint> | m.xml, line 2, <x>: is empty; expected a number of deg
          <waypoint><x>1</x><photoDistance>0</photoDistance></waypoint> | m.xml, line 2, <photoDistance>: 0.0 m is not a distance; expected more than 0 m
          <waypoint><x>1</x><lookAt>1</lookAt></waypoint> | m.xml, line 2, <lookAt>: Waypoint.lookAt: expected a point: two or three numbers, not "1"
          <waypoint><x>1</x><lookAt>8 95 0</lookAt></waypoint> | m.xml, line 2, <lookAt>: 95.0 is outside -90.0…90.0 deg of latitude (x is longitude, y is latitude)
          <station><turns>-1</turns></station> | m.xml, line 2, <turns>: Station.turns: expected 0.0…1000.0 1, not "-1.0"
          <waypoint><x>1</x><x>2</x></waypoint> | m.xml, line 2, <x>: appears twice; x is already in line 2
          <waypoint><x>181</x></waypoint> | m.xml, line 2, <x>: 181.0 is outside -180.0…180.0 deg of longitude
          <waypoint><x>50</x><y>-121</y></waypoint> | m.xml, line 2, <y>: -121.0 is outside -90.0…90.0 deg of latitude (x is longitude, y is latitude)
          <waypoint><x>1</x><completed>true</completed></waypoint> | m.xml, line 2, <completed>: unknown element in <waypoint>; expected name, next, description, timeLimit, choose, reference, x, y, z, phi, theta, psi, time, horizontalThreshold, verticalThreshold, speed, photoDistance, lookAt, landingStart, repeat, end
          <waypoint><x>1</x><horizontalTreshold>3</horizontalTreshold></waypoint> | m.xml, line 2, <horizontalTreshold>: unknown element in <waypoint>; expected name, next, description, timeLimit, choose, reference, x, y, z, phi, theta, psi, time, horizontalThreshold, verticalThreshold, speed, photoDistance, lookAt, landingStart, repeat, end; did you mean "horizontalThreshold"?
          <waypoint><x>1</x><horizontalThreshold>0</horizontalThreshold></waypoint> | m.xml, line 2, <horizontalThreshold>: 0.0 m can never be met; expected more than 0 m
          <waypoint><x>1</x><z>5</z><verticalThreshold>0</verticalThreshold></waypoint> | m.xml, line 2, <verticalThreshold>: 0.0 m can never be met; expected more than 0 m
          <waypoint><x>1</x><verticalThreshold>9</verticalThreshold></waypoint> | m.xml, line 2, <verticalThreshold>: has nothing to compare with: the goal has no <z>
          <waypoint><z>9</z></waypoint> | m.xml, line 2, <z>: is the only coordinate; expected a <verticalThreshold> as well
          <waypoint><x>1</x><speed>0</speed></waypoint> | m.xml, line 2, <speed>: 0.0 m/s never reaches the waypoint; expected more than 0 m/s
          <waypoint><x>1</x><reference>Body</reference></waypoint> | m.xml, line 2, <reference>: "BODY" moves with the vehicle; expected GLOBAL, LOCAL_ENU, LOCAL_NED or UTM
          <waypoint><x>1</x><reference>ENU</reference></waypoint> | `m.xml, line 2, <reference>: Waypoint.referenceFrame: "ENU" is not a reference frame; expected GLOBAL, LOCAL_ENU, LOCAL_NED, BODY, BODY_FRD, BODY_FLU or UTM <zone><N|S>`
          <waypoint><x>1</x><reference>UTM 4N</reference></waypoint> | m.xml, line 2, <waypoint>: lacks x or y; UTM needs both
          <waypoint><x>1</x></waypoint><waypoint><x>1</x><reference>Local NED</reference></waypoint> | m.xml, line 2, <reference>: is in LOCAL_NED, but the waypoint in line 2 is in GLOBAL; expected all on the earth or all on a local plane
          <waypoint><x>1</x><next>2</next></waypoint> | m.xml, line 2, <next>: "2" names no goal; the goals are 1
          <waypoint><x>1</x></waypoint><waypoint><name>1</name><x>2</x></waypoint> | m.xml, line 2, <name>: the goal in line 2 already has the name "1"; names must differ (without one, a goal's name is its number in the file)
          <waypoint colour="red"><x>1</x></waypoint> | m.xml, line 2, <waypoint>: unknown attribute "colour"; no attribute is expected here
          <waypoint><name unit="m">1</name><x>1</x></waypoint> | m.xml, line 2, <name>: has a unit, but uid is not a number
          <home><y>50</y></home><waypoint><x>1</x></waypoint> | m.xml, line 2, <home>: lacks <x>; expected x, y, and optionally z and psi
          <home><x>8</x><y>500</y></home><waypoint><x>1</x></waypoint> | m.xml, line 2, <y>: 500.0 is outside -90.0…90.0 deg of latitude (x is longitude, y is latitude)
          <home><x>8</x><y>50</y><psi>north</psi></home><waypoint><x>1</x></waypoint> | m.xml, line 2, <psi>: "north" is not a number of deg
          <home><x>8</x><y>50</y><reference>Body FRD</reference></home><waypoint><x>1</x></waypoint> | m.xml, line 2, <reference>: "BODY_FRD" moves with the vehicle; expected GLOBAL, LOCAL_ENU, LOCAL_NED or UTM
          <waypoint><x>1</x><next if="lost">1</next></waypoint> | m.xml, line 2, <next>: if: "lost" is not a result of a goal; expected one of done, failed, timed out
          <waypoint><x>1</x><next if="fail">1</next></waypoint> | m.xml, line 2, <next>: if: "fail" is not a result of a goal; expected one of done, failed, timed out; did you mean "failed"?
          <waypoint><x>1</x><next if="timed out">1</next></waypoint> | m.xml, line 2, <next>: if: the goal never times out because it has no <timeLimit>; expected one in the same goal
          <waypoint><x>1</x><next if="failed">dock</next></waypoint> | m.xml, line 2, <next>: "dock" names no goal; the goals are 1
          <waypoint><x>1</x><next if="failed">home</next></waypoint> | m.xml, line 2, <next>: "home" names no goal; the goals are 1
          <waypoint><x>1</x><next if="failed"/></waypoint> | m.xml, line 2, <next>: is empty; expected names of goals, or <end if="…"/>
          <waypoint><x>1</x><next if="failed">1</next><end if="failed"/></waypoint> | m.xml, line 2, <end>: contradicts <next if="failed"> of the same goal; expected only one
          <waypoint><x>1</x><end/></waypoint> | m.xml, line 2, <end>: attribute "if" is missing
          <waypoint><x>1</x><repeat from="2" times="3"/></waypoint> | m.xml, line 2, <repeat>: "2" names no goal; the goals are 1
          <waypoint><x>1</x><repeat from="1" times="0"/></waypoint> | m.xml, line 2, <repeat>: times: "0"; expected 1…1000000
          <waypoint><x>1</x><repeat from="1"/></waypoint> | m.xml, line 2, <repeat>: attribute "times" is missing
          <waypoint><x>1</x><timeLimit>0</timeLimit></waypoint> | m.xml, line 2, <timeLimit>: 0.0 s expires immediately; expected more than 0 s
          <waypoint><x>1</x><timeLimit unit="m">9</timeLimit></waypoint> | m.xml, line 2, <timeLimit>: unit "m" measures length, expected time: s, ms, us, µs, min, h
          <waypoint><x>1</x><choose>0</choose></waypoint> | m.xml, line 2, <choose>: 0 goals; expected at least 1
          <timeLimit next="dock">9</timeLimit><waypoint><x>1</x></waypoint> | m.xml, line 2, <timeLimit>: "dock" names no goal; the goals are 1
          <timeLimit>-9</timeLimit><waypoint><x>1</x></waypoint> | m.xml, line 2, <timeLimit>: -9.0 s; expected more than 0 s
          <timeLimit>9</timeLimit> | m.xml, line 1, <mission>: contains no goals; expected at least one, such as <waypoint><x>…</x><y>…</y></waypoint>
          """)
  void parse_badInput_saysWhereAndWhat(String content, String message) {
    assertThatThrownBy(() -> MissionTest.mission(content))
        .isInstanceOf(BadInputException.class)
        .hasMessage(message);
  }

  @Test
  void parse_unitOfAnotherQuantity_isRefusedWithTheUnitsThatWouldDo() {
    assertThatThrownBy(
            () -> MissionTest.mission("<waypoint><x>1</x><z unit=\"s\">3</z></waypoint>"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "m.xml, line 2, <z>: unit \"s\" measures time, expected length: m, km, cm, mm, ft, in, nmi, NM, mi");
  }

  @Test
  void load_noSuchFile_isNamed() {
    Path file = Paths.get("no", "such.xml");

    assertThatThrownBy(() -> Mission.load(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(file.toString());
  }
}
