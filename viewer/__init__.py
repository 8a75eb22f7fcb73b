"""What a user looks at: the drawing of a scene, its picture, reports of runs."""
