/**
 * Pictures of a camera as what is looked for in them: how bright, how coloured. Where it lies
 * belongs to {@link org.u2sa.vision.ground}.
 */
package org.u2sa.vision.picture;
