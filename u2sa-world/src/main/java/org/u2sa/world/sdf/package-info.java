/** Reads worlds of Gazebo (SDFormat, sdformat.org) as objects. */
package org.u2sa.world.sdf;
