package org.u2sa.world.object;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of the {@link ObjectMapModeller}. */
record ObjectMapVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "OBJECTS: types of objects not to be mapped because other modellers keep them, such as painted lines, separated by commas.")
        String unmappedTypes,
    @Variable(ifAbsentText = "")
        @Description(
            "OBJECTS: types of objects flat on the ground, such as potholes, separated by commas. A camera cannot see them behind an object that a scanner sees; a sighting there is part of that object.")
        String flatTypes,
    @Variable(unit = "m", min = 0.001, max = 10_000, ifAbsent = 0.3)
        @Description("OBJECTS: default standard deviation of a sighting.")
        double defaultSigma,
    @Variable(min = 1, max = 100, ifAbsent = 4)
        @Description(
            "OBJECTS: association gate, in combined standard deviations of sighting and object.")
        double gate,
    @Variable(ifAbsentText = "false")
        @Description(
            "OBJECTS: whether UIDs of sensors identify objects: one UID always means the same object, different UIDs different objects.")
        boolean trustUids,
    @Variable(min = 1, max = 31, ifAbsent = 3)
        @Description("OBJECTS: sightings within CONFIRM WINDOW that confirm an object.")
        int confirmHits,
    @Variable(min = 1, max = 31, ifAbsent = 5)
        @Description(
            "OBJECTS: opportunities to see an object, within which it must be seen CONFIRM HITS times or is dropped.")
        int confirmWindow,
    @Variable(min = 0.1, max = 0.999, ifAbsent = 0.9)
        @Description(
            "OBJECTS: probability that a sensor detects an object in its field of view; the higher, the sooner an unseen object there is dropped.")
        double detectionProbability,
    @Variable(ifAbsentText = "")
        @Description(
            "OBJECTS: fields of view of object sensors, such as Camera: 60 deg, 8 m; Radar: 120 deg, 150 m, 90 deg (width, reach, direction to the left). A sensor without an entry gives no negative evidence.")
        String fieldsOfView,
    @Variable(ifAbsentText = "")
        @Description(
            "OBJECTS: types of objects that scanners see, separated by commas, * for all: a beam through such an object is negative evidence.")
        String scannersSee,
    @Variable(ifAbsentText = "true")
        @Description(
            "OBJECTS: whether scanner echoes in formerly free space are tracked, and published once known to move.")
        boolean moversInScans,
    @Variable(unit = "m/s", min = 0, max = 1000, ifAbsent = 5)
        @Description("OBJECTS: typical speed of moving objects, 1 sigma; 0: nothing moves.")
        double usualSpeed,
    @Variable(ifAbsentText = "*")
        @Description(
            "OBJECTS: types of objects that can move, separated by commas; * for all. Objects of unknown type always can.")
        String movers,
    @Variable(unit = "m/s^2", min = 0, max = 100, ifAbsent = 1)
        @Description("OBJECTS: acceleration of moving objects, in speed or direction, 1 sigma.")
        double manoeuvres,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.05)
        @Description(
            "OBJECTS: error common to all sightings of a sensor, such as its mounting error, 1 sigma: averaging does not reduce it.")
        double systematicSigma,
    @Variable(unit = "s", min = 0, ifAbsent = 5)
        @Description("OBJECTS: time after which an unseen moving object is dropped; 0: never.")
        double forgetMoving,
    @Variable(unit = "s", min = 0, ifAbsent = 0)
        @Description("OBJECTS: time after which an unseen stationary object is dropped; 0: never.")
        double forgetStanding,
    @Variable(unit = "m", min = 0, max = 10_000, ifAbsent = 0.5)
        @Description("OBJECTS: distance within which two similar objects are merged.")
        double mergeWithin,
    @Variable(unit = "m", min = 0, max = 100_000, ifAbsent = 1)
        @Description(
            "OBJECTS: distance to keep from a moving object, added to its own radius in the moving sphere.")
        double buffer,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 10)
        @Description("OBJECTS: prediction horizon of an object's motion.")
        double horizon,
    @Variable(ifAbsentText = "false")
        @Description(
            "OBJECTS: whether objects of the world file are also dropped if they are not seen where they should be.")
        boolean doubtFile,
    @Variable(min = 1, max = 100_000, ifAbsent = 1000)
        @Description(
            "OBJECTS: maximum number of objects in addition to those of WORLD; the least certain are dropped.")
        int maxObjects) {
  ObjectMapVariables {
    if (confirmHits > confirmWindow) {
      throw new IllegalArgumentException(
          "CONFIRM HITS: " + confirmHits + " of CONFIRM WINDOW " + confirmWindow + " never happen");
    }
    FieldOfView.parse(fieldsOfView);
  }

  TrackFilter.Assumptions assumptions(String type) {
    boolean moves = type.isEmpty() || names(movers, type);
    return new TrackFilter.Assumptions(moves ? usualSpeed : 0.0, manoeuvres, systematicSigma);
  }

  boolean scannerSees(String type) {
    return names(scannersSee, type);
  }

  boolean isUnmapped(String type) {
    return names(unmappedTypes, type);
  }

  /** Whether objects of that type are flat and so can be occluded. */
  boolean isFlat(String type) {
    return names(flatTypes, type);
  }

  private static boolean names(String list, String type) {
    Set<String> types = new TreeSet<>(Arrays.asList(list.trim().split("\\s*,\\s*")));
    return types.contains("*") || !type.isEmpty() && types.contains(type);
  }
}
