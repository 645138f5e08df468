/** Modellers and their inputs: frames, poses, sightings. */
package org.u2sa.world.modeller;
