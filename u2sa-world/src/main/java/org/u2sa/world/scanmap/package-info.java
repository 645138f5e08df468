/** Scan-to-map matching, pose graph and loop closure: a map of scans that corrects the state. */
package org.u2sa.world.scanmap;
