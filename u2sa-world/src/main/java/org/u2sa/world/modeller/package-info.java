/** What a modeller is and gets: frames, poses, sightings. */
package org.u2sa.world.modeller;
