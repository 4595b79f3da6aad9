// The background as associated colours, SPEC.md, section 16; needed once a scene. 4 clocks late.
`default_nettype none

module background (
    input  wire        clock,
    input  wire [31:0] levels,  // B[c], unorm8, in bits 8 c + 7 to 8 c, c = 0 .. 3
    output wire [99:0] weighted // G[c], u25.17, in bits 25 c + 24 to 25 c
);
    genvar c;

    generate
        for (c = 0; c < 4; c = c + 1) begin : channel
            wire [7:0]  level = c == 3 ? 8'd255 : levels[8*c +: 8];
            wire [15:0] p, p2, middle, quotient256;
            wire [23:0] wide, sum;

            // div255(p) is the upper byte of quotient256, at most 255.
            mul #(.A(8), .B(8)) mul_p (clock, level, levels[31:24], p);
            add #(.WIDTH(16)) add_middle (clock, p, 16'd128, middle);
            add #(.WIDTH(16)) add_quotient (clock, middle, {8'd0, middle[15:8]}, quotient256);
            delay #(.WIDTH(16)) delay_p2 (clock, p, p2);
            add #(.WIDTH(24)) add_wide (clock, {p2, 8'd0}, {8'd0, p2}, wide);
            add #(.WIDTH(24)) add_sum (clock, wide, {16'd0, quotient256[15:8]}, sum);
            assign weighted[25*c +: 25] = {sum, 1'b0};
        end
    endgenerate
endmodule
