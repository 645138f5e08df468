/**
 * The record of which ground was seen at which resolution (thesis 4.4.1.3, 4.4.2). Plans to see the
 * rest do not belong here.
 */
package org.u2sa.world.coverage;
